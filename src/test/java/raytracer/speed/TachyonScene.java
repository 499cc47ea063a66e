package raytracer.speed;

import java.util.Locale;
import raytracer.scene.Camera;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** A scene in Tachyon's language, shaded as like ours as it can: its mirrors have one number and no colour. */
final class TachyonScene {

    private TachyonScene() { }

    static String of(Scene scene) {
        Camera c = scene.camera();
        StringBuilder out = new StringBuilder(String.format(Locale.ROOT, """
                BEGIN_SCENE
                RESOLUTION %d %d
                SHADER_MODE FULL
                END_SHADER_MODE
                CAMERA
                PROJECTION PERSPECTIVE
                ZOOM %s
                ASPECTRATIO 1.0
                ANTIALIASING 0
                RAYDEPTH %d
                CENTER %s
                VIEWDIR %s
                UPDIR %s
                END_CAMERA
                BACKGROUND 0 0 0
                """, scene.width(), scene.height(), 0.5 / Math.tan(Math.toRadians(c.fov() / 2)), scene.maxDepth(),
                vector(c.eye()), vector(c.at().minus(c.eye())), vector(c.up())));
        for (Light light : scene.lights()) {
            out.append(light instanceof Light.Point p
                    ? "LIGHT CENTER " + vector(p.position()) + " RAD 0.001 COLOR " + colour(p.colour()) + "\n"
                    : "DIRECTIONAL_LIGHT DIRECTION " + vector(((Light.Directional) light).towards().times(-1)) + " COLOR "
                            + colour(((Light.Directional) light).colour()) + "\n");
        }
        for (Shape shape : scene.shapes()) {
            String texture = texture(shape.material());
            if (shape instanceof Shape.Sphere s) {
                out.append("SPHERE CENTER ").append(vector(s.centre())).append(" RAD ").append(s.radius()).append(texture);
            } else if (shape instanceof Shape.Plane p) {
                out.append("PLANE CENTER ").append(vector(p.point())).append(" NORMAL ").append(vector(p.normal()))
                        .append(texture);
            } else {
                append((Shape.Triangles) shape, scene.mesh(), texture, out);
            }
        }
        return out.append("END_SCENE\n").toString();
    }

    private static void append(Shape.Triangles run, Mesh mesh, String texture, StringBuilder out) {
        for (int k = run.first(); k < run.first() + run.count(); k++) {
            out.append("TRI V0 ").append(vector(mesh.corner(k, 0))).append(" V1 ").append(vector(mesh.corner(k, 1)))
                    .append(" V2 ").append(vector(mesh.corner(k, 2))).append(texture);
        }
    }

    private static String texture(Material m) {
        Colour d = m.diffuse(), s = m.specular();
        double most = Math.max(d.red(), Math.max(d.green(), d.blue())), scale = most > 0 ? most : 1;
        double mirror = Math.max(s.red(), Math.max(s.green(), s.blue()));
        return String.format(Locale.ROOT, " TEXTURE AMBIENT 0 DIFFUSE %s SPECULAR %s OPACITY 1 PHONG PLASTIC %s PHONG_SIZE %s"
                + " COLOR %s TEXFUNC 0\n", scale, mirror, mirror, Math.max(1, m.shininess()),
                d.red() / scale + " " + d.green() / scale + " " + d.blue() / scale);
    }

    private static String vector(Vector v) {
        return v.x() + " " + v.y() + " " + v.z();
    }

    private static String colour(Colour c) {
        return c.red() + " " + c.green() + " " + c.blue();
    }
}
