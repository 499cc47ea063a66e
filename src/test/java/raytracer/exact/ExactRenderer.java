package raytracer.exact;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;

/**
 * The format's text turned into code as directly as possible, in arithmetic of 104 bits: the judge of what the tracer
 * makes of a scene. A {@link BoxTree} leaves out what a ray is far from; all else is decided exactly.
 */
public final class ExactRenderer {

    /**
     * Far above the rounding errors here (2^-100), far below what doubles can tell apart (2^-53): numbers closer than
     * this, relative to the terms they come from, are equal.
     */
    private static final double EQUAL = 0x1p-84;

    /** One surface; the corners of a triangle, or a sphere's centre or plane's point in a. */
    private record Surface(Kind kind, ExactVector a, ExactVector b, ExactVector c, ExactVector normal, Exact radius,
            Material material) { }

    private enum Kind { SPHERE, PLANE, TRIANGLE }

    private final Scene scene;
    private final List<Surface> surfaces = new ArrayList<>();
    private final BoxTree tree;
    private final ExactVector eye;
    private final ExactVector right;
    private final ExactVector up;
    private final ExactVector backward;
    private final Exact halfHeight;

    public ExactRenderer(Scene scene) {
        this.scene = scene;
        eye = ExactVector.of(scene.camera().eye());
        backward = eye.minus(ExactVector.of(scene.camera().at())).unit();
        right = ExactVector.of(scene.camera().up()).cross(backward).unit();
        up = backward.cross(right);
        Exact pi = new Exact(Math.PI, 1.2246467991473532e-16);
        halfHeight = pi.times(scene.camera().fov()).over(Exact.of(360)).tangent();
        for (Shape shape : scene.shapes()) {
            add(shape, scene.mesh());
        }
        tree = new BoxTree(surfaces.stream().map(ExactRenderer::box).toArray(double[][]::new));
    }

    /** Null if it has none. */
    private static double[] box(Surface s) {
        if (s.kind == Kind.PLANE) {
            return null;
        }
        double r = s.radius.high();
        double[][] corners = {s.a.high(), s.b.high(), s.c.high()};
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            double a = corners[0][axis], b = corners[1][axis], c = corners[2][axis];
            box[axis] = Math.min(a, Math.min(b, c)) - r;
            box[axis + 3] = Math.max(a, Math.max(b, c)) + r;
        }
        return box;
    }

    /** What a ray may hit, in the order of declaration. */
    private int[] candidates(ExactVector o, ExactVector d) {
        IntStream.Builder found = IntStream.builder();
        tree.find(o.rounded(), d.rounded(), found::add);
        return found.build().sorted().toArray();
    }

    private void add(Shape shape, Mesh mesh) {
        if (shape instanceof Shape.Sphere s) {
            ExactVector c = ExactVector.of(s.centre());
            surfaces.add(new Surface(Kind.SPHERE, c, c, c, c, Exact.of(s.radius()), s.material()));
        } else if (shape instanceof Shape.Plane p) {
            ExactVector q = ExactVector.of(p.point());
            surfaces.add(new Surface(Kind.PLANE, q, q, q, ExactVector.of(p.normal()).unit(), Exact.ZERO, p.material()));
        } else if (shape instanceof Shape.Triangles run) {
            for (int t = run.first(); t < run.first() + run.count(); t++) {
                ExactVector a = ExactVector.of(mesh.corner(t, 0)), b = ExactVector.of(mesh.corner(t, 1)),
                        c = ExactVector.of(mesh.corner(t, 2));
                ExactVector n = b.minus(a).cross(c.minus(a));
                boolean empty = n.x().sign() == 0 && n.y().sign() == 0 && n.z().sign() == 0;
                surfaces.add(new Surface(Kind.TRIANGLE, a, b, c, empty ? n : n.unit(), Exact.ZERO, run.material()));
            }
        }
    }

    /** A pixel as 0xRRGGBB. */
    public int pixel(int x, int y) {
        Exact a = halfHeight.times(2.0 * x + 1 - scene.width()).over(Exact.of(scene.height()));
        Exact b = halfHeight.times(scene.height() - 1 - 2.0 * y).over(Exact.of(scene.height()));
        Exact[] colour = colour(eye, right.times(a).plus(up.times(b)).minus(backward).unit());
        return bits(colour[0]) << 16 | bits(colour[1]) << 8 | bits(colour[2]);
    }

    /** floor(255 c + 1/2) in floats, as {@code java.awt.Color} has it; c is cut to [0, 1]. */
    private static int bits(Exact c) {
        float product = nearestFloat(c.high() >= 1 ? Exact.ONE : c) * 255;
        return (int) (product + 0.5);
    }

    /** The float nearest to a number, which its double alone does not tell where that is between two floats. */
    private static float nearestFloat(Exact c) {
        float nearest = (float) c.high();
        float other = c.low() > 0 ? Math.nextUp(nearest) : Math.nextDown(nearest);
        boolean isBetween = ((double) nearest + other) / 2 == c.high() && Math.abs(c.low()) > EQUAL * c.high();
        return isBetween ? other : nearest;
    }

    private Exact[] colour(ExactVector origin, ExactVector direction) {
        Exact[] sum = {Exact.ZERO, Exact.ZERO, Exact.ZERO};
        Exact[] through = {Exact.ONE, Exact.ONE, Exact.ONE};
        ExactVector o = origin, d = direction;
        Surface source = null;
        for (int depth = 1; depth <= scene.maxDepth(); depth++) {
            Hit hit = nearest(o, d, source);
            if (hit == null) {
                break;
            }
            source = hit.surface;
            ExactVector p = o.plus(d.times(hit.distance));
            ExactVector n = source.kind == Kind.SPHERE ? p.minus(source.a).unit() : source.normal;
            p = source.kind == Kind.SPHERE ? source.a.plus(n.times(source.radius)) : p;
            Exact[] here = shade(p, d, n, source);
            Colour mirror = source.material.specular();
            double[] factors = {mirror.red(), mirror.green(), mirror.blue()};
            for (int i = 0; i < 3; i++) {
                sum[i] = sum[i].plus(product(through[i], here[i]));
                through[i] = through[i].times(factors[i]);
            }
            if (mirror.isBlack()) {
                break;
            }
            o = p;
            d = d.plus(n.times(n.dot(d).times(-2))).unit();
        }
        return sum;
    }

    private Exact[] shade(ExactVector p, ExactVector d, ExactVector n, Surface surface) {
        Material m = surface.material;
        Exact[] c = {Exact.of(m.ambient().red()), Exact.of(m.ambient().green()), Exact.of(m.ambient().blue())};
        for (Light light : scene.lights()) {
            ExactVector way = light instanceof Light.Directional l ? ExactVector.of(l.towards())
                    : ExactVector.of(((Light.Point) light).position()).minus(p);
            if (way.size() == 0) {
                continue;
            }
            Exact far = light instanceof Light.Directional ? null : way.length();
            ExactVector l = way.unit();
            if (scene.shadow() && blocked(p, l, far, surface)) {
                continue;
            }
            Exact lambert = n.dot(l).sign() > 0 ? n.dot(l) : Exact.ZERO;
            ExactVector h = l.minus(d);
            Exact cosine = h.size() == 0 ? Exact.ZERO : n.dot(h.unit());
            Exact highlight = (cosine.sign() > 0 ? cosine : Exact.ZERO).power(m.shininess());
            double[] colour = {light.colour().red(), light.colour().green(), light.colour().blue()};
            double[] diffuse = {m.diffuse().red(), m.diffuse().green(), m.diffuse().blue()};
            double[] specular = {m.specular().red(), m.specular().green(), m.specular().blue()};
            for (int i = 0; i < 3; i++) {
                c[i] = c[i].plus(lambert.times(diffuse[i]).times(colour[i]))
                        .plus(product(highlight, Exact.of(specular[i]).times(colour[i])));
            }
        }
        return c;
    }

    /** Nothing of something infinite is nothing. */
    private static Exact product(Exact a, Exact b) {
        if (a.sign() == 0 || b.sign() == 0) {
            return Exact.ZERO;
        }
        return Double.isInfinite(a.high()) || Double.isInfinite(b.high()) ? Exact.of(Double.MAX_VALUE) : a.times(b);
    }

    private record Hit(Surface surface, Exact distance) { }

    /** Of equal distances the first declared. */
    private Hit nearest(ExactVector o, ExactVector d, Surface source) {
        Hit best = null;
        for (int i : candidates(o, d)) {
            Surface s = surfaces.get(i);
            Exact t = meet(s, o, d, s == source);
            if (t != null && (best == null || best.distance.minus(t).high() > EQUAL * best.distance.high())) {
                best = new Hit(s, t);
            }
        }
        return best;
    }

    private boolean blocked(ExactVector o, ExactVector d, Exact far, Surface source) {
        for (int i : candidates(o, d)) {
            Surface s = surfaces.get(i);
            Exact t = meet(s, o, d, s == source);
            if (t != null && (far == null || far.minus(t).high() > EQUAL * (far.high() + o.size()))) {
                return true;
            }
        }
        return false;
    }

    /** The least distance above 0 at which a ray meets a surface; null if there is none. */
    private static Exact meet(Surface s, ExactVector o, ExactVector d, boolean leaving) {
        return switch (s.kind) {
            case SPHERE -> meetSphere(s, o, d, leaving);
            case PLANE -> leaving ? null : meetPlane(s, o, d);
            case TRIANGLE -> leaving || !passesWithin(s, o, d) ? null : meetPlane(s, o, d);
        };
    }

    private static Exact meetSphere(Surface s, ExactVector o, ExactVector d, boolean leaving) {
        ExactVector x = o.minus(s.a);
        Exact along = x.dot(d);
        ExactVector perpendicular = x.minus(d.times(along));
        Exact square = s.radius.times(s.radius).minus(perpendicular.dot(perpendicular));
        double size = o.size() + s.a.size() + s.radius.high();
        if (square.high() < -EQUAL * size * size) {
            return null;
        }
        Exact power = x.dot(x).minus(s.radius.times(s.radius));
        if (leaving || power.abs().high() <= EQUAL * s.radius.high() * size) {
            Exact t = along.times(-2);
            return t.high() > EQUAL * size ? t : null;
        }
        // A tangent touches in one point; the root of what rounding leaves would make two of it.
        Exact half = square.high() <= EQUAL * size * size ? Exact.ZERO : square.root();
        Exact near = along.negated().minus(half), far = along.negated().plus(half);
        return power.sign() > 0 ? near.sign() > 0 ? near : null : far.sign() > 0 ? far : null;
    }

    private static Exact meetPlane(Surface s, ExactVector o, ExactVector d) {
        Exact offset = s.a.minus(o).dot(s.normal);
        Exact cosine = d.dot(s.normal);
        boolean on = offset.abs().high() <= EQUAL * (o.size() + s.a.size());
        return on || offset.sign() * cosine.sign() <= 0 || cosine.abs().high() <= EQUAL ? null : offset.over(cosine);
    }

    private static boolean passesWithin(Surface s, ExactVector o, ExactVector d) {
        if (s.normal.size() == 0) {
            return false;
        }
        double size = o.size() + s.a.size() + s.b.size() + s.c.size();
        int ab = side(s.a, s.b, o, d, size), bc = side(s.b, s.c, o, d, size), ca = side(s.c, s.a, o, d, size);
        return ab >= 0 && bc >= 0 && ca >= 0 || ab <= 0 && bc <= 0 && ca <= 0;
    }

    private static int side(ExactVector a, ExactVector b, ExactVector o, ExactVector d, double size) {
        Exact volume = d.dot(a.minus(o).cross(b.minus(o)));
        return volume.abs().high() <= EQUAL * size * size ? 0 : volume.sign();
    }
}
