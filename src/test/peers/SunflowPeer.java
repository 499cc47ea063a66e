import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.sunflow.SunflowAPI;
import org.sunflow.core.display.FileDisplay;
import org.sunflow.math.Matrix4;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;
import org.sunflow.system.UI;
import raytracer.parser.SceneParser;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/**
 * A scene by Sunflow, whose package reads no files: SCENE OUT.png THREADS SAMPLES-ALONG-A-PIXEL'S-SIDE. It has either
 * highlights or mirrors, and lights at infinity are points far away: about as much work as ours, another picture.
 */
public final class SunflowPeer {

    private static final double FAR = 1e4, POWER = 1000;

    private final SunflowAPI api = new SunflowAPI();
    private int names;

    public static void main(String[] args) throws Exception {
        UI.verbosity(0);
        Scene scene;
        try (InputStream in = Files.newInputStream(Path.of(args[0]))) {
            scene = SceneParser.parse(args[0], in).scene();
        }
        new SunflowPeer().render(scene, args[1], Integer.parseInt(args[2]), Integer.parseInt(args[3]));
        System.exit(0);
    }

    private void render(Scene scene, String file, int threads, int samples) {
        api.reset();
        for (Light light : scene.lights()) {
            Vector at = light instanceof Light.Point p ? p.position() : ((Light.Directional) light).towards().unit().times(FAR);
            api.parameter("center", point(at));
            api.parameter("power", null, colour(light.colour(), POWER));
            api.light("light" + names++, "point");
        }
        scene.shapes().forEach(shape -> add(shape, scene));
        Vector eye = scene.camera().eye(), look = scene.camera().at(), up = scene.camera().up();
        double aspect = (double) scene.width() / scene.height(), half = Math.tan(Math.toRadians(scene.camera().fov() / 2));
        api.parameter("transform", Matrix4.lookAt(point(eye), point(look), vector(up)));
        api.parameter("fov", (float) Math.toDegrees(2 * Math.atan(half * aspect)));
        api.parameter("aspect", (float) aspect);
        api.camera("camera", "pinhole");
        api.parameter("camera", "camera");
        api.parameter("resolutionX", scene.width());
        api.parameter("resolutionY", scene.height());
        int steps = (int) Math.round(Math.log(samples) / Math.log(2));
        api.parameter("aa.min", steps);
        api.parameter("aa.max", steps);
        api.parameter("aa.samples", 1);
        api.parameter("filter", "box");
        api.parameter("depths.reflection", scene.maxDepth() - 1);
        api.parameter("depths.diffuse", 0);
        api.parameter("threads", threads);
        api.parameter("threads.lowPriority", false);
        api.options(SunflowAPI.DEFAULT_OPTIONS);
        api.render(SunflowAPI.DEFAULT_OPTIONS, new FileDisplay(file));
    }

    private void add(Shape shape, Scene scene) {
        String shader = shader(shape.material(), scene.maxDepth() > 1), geometry = "geometry" + names++;
        Matrix4 place = null;
        if (shape instanceof Shape.Sphere s) {
            api.geometry(geometry, "sphere");
            place = Matrix4.translation((float) s.centre().x(), (float) s.centre().y(), (float) s.centre().z())
                    .multiply(Matrix4.scale((float) s.radius()));
        } else if (shape instanceof Shape.Plane p) {
            api.parameter("center", point(p.point()));
            api.parameter("normal", vector(p.normal()));
            api.geometry(geometry, "plane");
        } else {
            Shape.Triangles run = (Shape.Triangles) shape;
            float[] points = new float[9 * run.count()];
            int[] corners = new int[3 * run.count()];
            for (int i = 0; i < corners.length; i++) {
                corners[i] = i;
                for (int axis = 0; axis < 3; axis++) {
                    points[3 * i + axis] = (float) scene.mesh().coordinate(run.first() + i / 3, i % 3, axis);
                }
            }
            api.parameter("triangles", corners);
            api.parameter("points", "point", "vertex", points);
            api.geometry(geometry, "triangle_mesh");
        }
        api.parameter("shaders", shader);
        if (place != null) {
            api.parameter("transform", place);
        }
        api.instance("instance" + names++, geometry);
    }

    private String shader(Material m, boolean mirrors) {
        String name = "shader" + names++;
        double mirror = Math.max(m.specular().red(), Math.max(m.specular().green(), m.specular().blue()));
        api.parameter("diffuse", null, colour(m.diffuse(), 1));
        if (mirrors && mirror > 0) {
            api.parameter("shiny", (float) mirror);
            api.shader(name, "shiny_diffuse");
        } else {
            api.parameter("specular", null, colour(m.specular(), 1));
            api.parameter("power", (float) Math.max(1, m.shininess()));
            api.parameter("samples", 0);
            api.shader(name, "phong");
        }
        return name;
    }

    private static Point3 point(Vector v) {
        return new Point3((float) v.x(), (float) v.y(), (float) v.z());
    }

    private static Vector3 vector(Vector v) {
        return new Vector3((float) v.x(), (float) v.y(), (float) v.z());
    }

    private static float[] colour(Colour c, double factor) {
        return new float[] {(float) (factor * c.red()), (float) (factor * c.green()), (float) (factor * c.blue())};
    }
}
