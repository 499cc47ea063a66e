package raytracer.speed;

import java.util.List;
import java.util.Locale;
import raytracer.scene.Camera;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** A scene in POV-Ray's language. Its highlights are Phong's, not Blinn's; the rest is the same. */
final class PovScene {

    private PovScene() { }

    static String of(Scene scene) {
        StringBuilder pov = new StringBuilder("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level "
                + scene.maxDepth() + " }\nbackground { rgb 0 }\n");
        pov.append(camera(scene.camera(), (double) scene.width() / scene.height()));
        for (Light light : scene.lights()) {
            pov.append(light instanceof Light.Point point
                    ? "light_source { " + vector(point.position()) + " rgb " + colour(point.colour()) + " }\n"
                    : "light_source { " + vector(((Light.Directional) light).towards()) + " * 1e5 rgb "
                            + colour(((Light.Directional) light).colour()) + " parallel point_at 0 }\n");
        }
        for (Shape shape : scene.shapes()) {
            pov.append(shape(shape, scene.mesh()));
        }
        return pov.toString();
    }

    private static String camera(Camera camera, double aspect) {
        double across = 2 * Math.toDegrees(Math.atan(Math.tan(Math.toRadians(camera.fov() / 2)) * aspect));
        return "camera { location " + vector(camera.eye()) + " up y right -x * " + aspect + " direction -z sky "
                + vector(camera.up()) + " angle " + across + " look_at " + vector(camera.at()) + " }\n";
    }

    private static String shape(Shape shape, Mesh mesh) {
        if (shape instanceof Shape.Sphere s) {
            return "sphere { " + vector(s.centre()) + ", " + s.radius() + texture(s.material()) + " }\n";
        }
        if (shape instanceof Shape.Plane p) {
            Vector n = p.normal().unit();
            return "plane { " + vector(n) + ", " + p.point().dot(n) + texture(p.material()) + " }\n";
        }
        Shape.Triangles run = (Shape.Triangles) shape;
        StringBuilder triangles = new StringBuilder("mesh {\n");
        for (int k = run.first(); k < run.first() + run.count(); k++) {
            triangles.append("triangle { ").append(String.join(", ", List.of(vector(mesh.corner(k, 0)),
                    vector(mesh.corner(k, 1)), vector(mesh.corner(k, 2))))).append(" }\n");
        }
        return triangles + texture(run.material()) + " }\n";
    }

    private static String texture(Material m) {
        return String.format(Locale.ROOT, " texture { pigment { rgb %s } finish { ambient 0 emission %s diffuse 1 phong %s"
                + " phong_size %s reflection { rgb %s } } }", colour(m.diffuse()), colour(m.ambient()),
                Math.max(m.specular().red(), Math.max(m.specular().green(), m.specular().blue())), m.shininess(),
                colour(m.specular()));
    }

    private static String vector(Vector v) {
        return "<" + v.x() + ", " + v.y() + ", " + v.z() + ">";
    }

    private static String colour(Colour c) {
        return "<" + c.red() + ", " + c.green() + ", " + c.blue() + ">";
    }
}
