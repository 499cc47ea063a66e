package raytracer.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import raytracer.image.Image;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/**
 * A tracer of direct light in plain doubles, without any tolerance: a ray leaves out the surface that it leaves, and what
 * rounding gives decides. The least that ours must be as good as.
 */
final class PlainDoubles {

    private final Scene scene;
    private final List<Surface> surfaces = new ArrayList<>();

    /** @param corners three of a triangle, one of a plane; null of a sphere, whose centre is in {@code at} */
    private record Surface(Vector at, double radius, Vector normal, Vector[] corners, Material material) { }

    PlainDoubles(Scene scene) {
        this.scene = scene;
        for (Shape shape : scene.shapes()) {
            if (shape instanceof Shape.Sphere s) {
                surfaces.add(new Surface(s.centre(), s.radius(), null, null, s.material()));
            } else if (shape instanceof Shape.Plane p) {
                surfaces.add(new Surface(p.point(), 0, p.normal().unit(), new Vector[0], p.material()));
            } else if (shape instanceof Shape.Triangles run) {
                IntStream.range(run.first(), run.first() + run.count()).forEach(t -> addTriangle(t, run.material()));
            }
        }
    }

    private void addTriangle(int t, Material material) {
        Vector[] c = {scene.mesh().corner(t, 0), scene.mesh().corner(t, 1), scene.mesh().corner(t, 2)};
        surfaces.add(new Surface(c[0], 0, c[1].minus(c[0]).cross(c[2].minus(c[0])).unit(), c, material));
    }

    /** A pixel as 0xRRGGBB. */
    int pixel(int x, int y) {
        Vector w = scene.camera().backward(), u = scene.camera().right(), v = w.cross(u);
        double half = Math.tan(Math.toRadians(scene.camera().fov() / 2));
        double a = half * (2 * x + 1 - scene.width()) / scene.height(), b = half * (scene.height() - 1 - 2 * y) / scene.height();
        double[] c = colour(scene.camera().eye(), u.times(a).minus(v.times(-b)).minus(w).unit());
        Image image = new Image(1, 1);
        image.setPixels(0, 0, 1, 1, new double[] {c[0]}, new double[] {c[1]}, new double[] {c[2]});
        return image.rgb(0, 0);
    }

    private double[] colour(Vector o, Vector d) {
        Surface hit = null;
        double t = Double.POSITIVE_INFINITY;
        for (Surface s : surfaces) {
            double distance = distance(s, o, d, false);
            hit = distance < t ? s : hit;
            t = distance < t ? distance : t;
        }
        if (hit == null) {
            return new double[3];
        }
        Vector p = o.minus(d.times(-t)), n = hit.corners == null ? p.minus(hit.at).unit() : hit.normal;
        Colour diffuse = hit.material.diffuse(), ambient = hit.material.ambient();
        double[] sum = {ambient.red(), ambient.green(), ambient.blue()};
        for (Light light : scene.lights()) {
            Vector way = light instanceof Light.Directional l ? l.towards() : ((Light.Point) light).position().minus(p);
            double far = light instanceof Light.Directional ? Double.POSITIVE_INFINITY : way.length();
            if (!isBlocked(p, way.unit(), far, hit)) {
                double lambert = Math.max(0, n.dot(way.unit()));
                sum[0] += light.colour().red() * diffuse.red() * lambert;
                sum[1] += light.colour().green() * diffuse.green() * lambert;
                sum[2] += light.colour().blue() * diffuse.blue() * lambert;
            }
        }
        return sum;
    }

    private boolean isBlocked(Vector o, Vector d, double far, Surface source) {
        return surfaces.stream().anyMatch(s -> distance(s, o, d, s == source) < far);
    }

    /** NaN if there is no hit. */
    private static double distance(Surface s, Vector o, Vector d, boolean isSource) {
        if (s.corners == null) {
            Vector x = o.minus(s.at);
            double along = x.dot(d);
            Vector e = x.minus(d.times(along));
            double half = Math.sqrt(s.radius * s.radius - e.dot(e));
            double t = isSource ? -2 * along : -along - half > 0 ? -along - half : half - along;
            return t > 0 ? t : Double.NaN;
        }
        double t = s.at.minus(o).dot(s.normal) / d.dot(s.normal);
        return isSource || !(t > 0) || s.corners.length > 0 && !isWithin(s.corners, o, d) ? Double.NaN : t;
    }

    private static boolean isWithin(Vector[] corners, Vector o, Vector d) {
        Vector a = corners[0].minus(o), b = corners[1].minus(o), c = corners[2].minus(o);
        double ab = d.dot(a.cross(b)), bc = d.dot(b.cross(c)), ca = d.dot(c.cross(a));
        return ab >= 0 && bc >= 0 && ca >= 0 || ab <= 0 && bc <= 0 && ca <= 0;
    }
}
