package raytracer.tracer;

import java.util.ArrayList;
import java.util.List;
import raytracer.image.Image;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.primitive.SphereBounds;
import raytracer.tracer.primitive.TriangleBounds;

/**
 * A whole recursive tracer as in textbooks, for comparison: quadratic formula, Moeller-Trumbore, whatever comes first of
 * equal distances, and a fixed epsilon; over the same trees as ours, so that only the methods differ. In float, every
 * number that is kept (points, directions, normals, distances) is rounded to float.
 */
public final class Textbook {

    private final Scene scene;
    private final boolean inFloat;
    private final double epsilon;
    private final List<Shape.Plane> planes = new ArrayList<>();
    private final List<Shape.Sphere> spheres = new ArrayList<>();
    private final List<Material> triangleMaterials = new ArrayList<>();
    private final Bvh sphereTree;
    private final Bvh triangleTree;
    private final BvhWalk walk = new BvhWalk();

    // Of the camera.
    private final Vector w, u, v;
    private final double half;

    private double t;
    private Vector normal;
    private Material material;

    public Textbook(Scene scene, boolean inFloat, double epsilon) {
        this.scene = scene;
        this.inFloat = inFloat;
        this.epsilon = epsilon;
        w = scene.camera().backward();
        u = scene.camera().right();
        v = w.cross(u);
        half = Math.tan(Math.toRadians(scene.camera().fov() / 2));
        for (Shape shape : scene.shapes()) {
            if (shape instanceof Shape.Plane p) {
                planes.add(p);
            } else if (shape instanceof Shape.Sphere s) {
                spheres.add(s);
            } else {
                for (int k = 0; k < shape.count(); k++) {
                    triangleMaterials.add(shape.material());
                }
            }
        }
        sphereTree = BvhBuilder.build(spheres.size(), new SphereBounds(spheres), Bvh.LEAF_SIZE);
        triangleTree = BvhBuilder.build(
                scene.mesh().triangles(), new TriangleBounds(scene.mesh()), Bvh.LEAF_SIZE);
    }

    /** Renders on the calling thread. */
    public void render(Image image) {
        render(image, 0, 1, 1);
    }

    /**
     * Renders one row in so many, on the calling thread.
     *
     * @param samples along a pixel's side
     */
    public void render(Image image, int firstRow, int rows, int samples) {
        Vector eye = rounded(scene.camera().eye());
        double[] red = new double[scene.width()], green = new double[scene.width()], blue = new double[scene.width()];
        for (int y = firstRow; y < scene.height(); y += rows) {
            for (int x = 0; x < scene.width(); x++) {
                double[] sum = new double[3];
                for (int k = 0; k < samples * samples; k++) {
                    double[] c = colour(eye, towards(x + (k % samples + .5) / samples, y + (k / samples + .5) / samples), 1);
                    for (int i = 0; i < 3; i++) {
                        sum[i] += Math.min(1, c[i]);
                    }
                }
                red[x] = sum[0] / samples / samples;
                green[x] = sum[1] / samples / samples;
                blue[x] = sum[2] / samples / samples;
            }
            image.setPixels(0, y, scene.width(), 1, red, green, blue);
        }
    }

    /** From the eye to a point of the picture, in pixels from its top left corner. */
    private Vector towards(double x, double y) {
        double a = half * (2 * x - scene.width()) / scene.height(), b = half * (scene.height() - 2 * y) / scene.height();
        return rounded(new Vector(a * u.x() + b * v.x() - w.x(), a * u.y() + b * v.y() - w.y(),
                a * u.z() + b * v.z() - w.z()).unit());
    }

    private double rounded(double x) {
        return inFloat ? (float) x : x;
    }

    private Vector rounded(Vector v) {
        return inFloat ? new Vector((float) v.x(), (float) v.y(), (float) v.z()) : v;
    }

    private double[] colour(Vector o, Vector d, int depth) {
        if (!nearest(o, d, Double.POSITIVE_INFINITY)) {
            return new double[3];
        }
        Vector p = rounded(new Vector(o.x() + t * d.x(), o.y() + t * d.y(), o.z() + t * d.z()));
        Vector n = normal;
        Material m = material;
        double[] c = {m.ambient().red(), m.ambient().green(), m.ambient().blue()};
        for (Light light : scene.lights()) {
            Vector way = light instanceof Light.Directional l ? l.towards() : ((Light.Point) light).position().minus(p);
            Vector l = rounded(way.unit());
            if (nearest(p, l, light instanceof Light.Directional ? Double.POSITIVE_INFINITY : way.length())) {
                continue;
            }
            double lambert = Math.max(0, n.dot(l));
            double highlight = Math.pow(Math.max(0, n.dot(l.minus(d).unit())), m.shininess());
            add(c, light.colour(), m.diffuse(), lambert);
            add(c, light.colour(), m.specular(), highlight);
        }
        if (depth < scene.maxDepth() && !m.specular().isBlack()) {
            double twice = 2 * d.dot(n);
            Vector r = rounded(new Vector(d.x() - twice * n.x(), d.y() - twice * n.y(), d.z() - twice * n.z()));
            double[] mirrored = colour(p, r, depth + 1);
            c[0] += m.specular().red() * mirrored[0];
            c[1] += m.specular().green() * mirrored[1];
            c[2] += m.specular().blue() * mirrored[2];
        }
        return c;
    }

    private static void add(double[] c, Colour light, Colour surface, double factor) {
        c[0] += light.red() * surface.red() * factor;
        c[1] += light.green() * surface.green() * factor;
        c[2] += light.blue() * surface.blue() * factor;
    }

    private boolean nearest(Vector o, Vector d, double far) {
        t = far;
        boolean found = false;
        for (Shape.Plane plane : planes) {
            Vector n = plane.normal().unit();
            double distance = rounded(plane.point().minus(o).dot(n)) / rounded(d.dot(n));
            if (distance > epsilon && distance < t) {
                found = true;
                t = rounded(distance);
                normal = n;
                material = plane.material();
            }
        }
        for (int k = 0; k < sphereTree.oversized(); k++) {
            found |= sphere(spheres.get(sphereTree.order()[k]), o, d);
        }
        setOut(sphereTree, o, d);
        while (walk.nextLeaf(t)) {
            for (int k = walk.first; k < walk.end; k++) {
                found |= sphere(spheres.get(sphereTree.order()[k]), o, d);
            }
        }
        for (int k = 0; k < triangleTree.oversized(); k++) {
            found |= triangle(triangleTree.order()[k], o, d);
        }
        setOut(triangleTree, o, d);
        while (walk.nextLeaf(t)) {
            for (int k = walk.first; k < walk.end; k++) {
                found |= triangle(triangleTree.order()[k], o, d);
            }
        }
        return found;
    }

    private void setOut(Bvh tree, Vector o, Vector d) {
        if (walk.start(tree, o.x(), o.y(), o.z(), d.x(), d.y(), d.z())) {
        }
    }

    private boolean sphere(Shape.Sphere sphere, Vector o, Vector d) {
        Vector x = rounded(o.minus(sphere.centre()));
        double b = rounded(x.dot(d)), c = rounded(rounded(x.dot(x)) - rounded(sphere.radius() * sphere.radius()));
        double discriminant = rounded(b * b) - c;
        if (discriminant < 0) {
            return false;
        }
        double root = rounded(Math.sqrt(discriminant));
        double distance = rounded(-b - root > epsilon ? -b - root : root - b);
        if (!(distance > epsilon && distance < t)) {
            return false;
        }
        t = distance;
        Vector p = new Vector(o.x() + t * d.x(), o.y() + t * d.y(), o.z() + t * d.z());
        normal = rounded(rounded(p).minus(sphere.centre()).unit());
        material = sphere.material();
        return true;
    }

    private boolean triangle(int k, Vector o, Vector d) {
        Vector a = scene.mesh().corner(k, 0), e1 = scene.mesh().corner(k, 1).minus(a), e2 = scene.mesh().corner(k, 2).minus(a);
        Vector p = rounded(d.cross(e2));
        double determinant = rounded(e1.dot(p));
        if (Math.abs(determinant) <= 1e-12) {
            return false;
        }
        Vector s = rounded(o.minus(a));
        double u = rounded(s.dot(p) / determinant);
        Vector q = rounded(s.cross(e1));
        double v = rounded(d.dot(q) / determinant);
        double distance = rounded(e2.dot(q) / determinant);
        if (u < 0 || v < 0 || u + v > 1 || !(distance > epsilon && distance < t)) {
            return false;
        }
        t = distance;
        normal = rounded(e1.cross(e2).unit());
        material = triangleMaterials.get(k);
        return true;
    }
}
