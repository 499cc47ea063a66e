package raytracer.tracer.primitive;

import raytracer.scene.Mesh;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.Rays;

/**
 * The triangles of a mesh in the order of a tree's leaves, and where one ray passes one of them: see {@link Triangles}
 * for the method.
 */
final class TriangleArray {

    /** Numbers of one triangle in {@link #numbers}. */
    private static final int STRIDE = 4;

    /**
     * A ray whose cosine with a triangle's normal is greater hits the triangle's plane at a distance that is exact
     * enough to be compared with others at once: off by less than {@link Rounding#TIE_SIEVE}.
     */
    static final double GRAZING = 0x1p-16;

    /**
     * Of a triangle's size: so far beside it a hit is in its box all the same, as boxes are enlarged by more
     * ({@link Bvh#PADDING}, of which this needs v).
     */
    private static final double IN_BOX = 0x1p-26;

    /** Of the distance at which a ray hits a triangle's plane: a corner farther away than this is far. */
    private static final double FAR = 16;

    private final Mesh mesh;
    /** By a triangle's number here: its number in the mesh. */
    private final int[] order;
    /** By triangle: the unit normal; then |x| + |y| + |z| of two edges, summed: no edge is longer. */
    private final double[] numbers;
    private final double room;

    TriangleArray(Mesh mesh, Bvh bvh) {
        this.mesh = mesh;
        order = bvh.order();
        room = bvh.room();
        numbers = new double[Math.multiplyExact(STRIDE, order.length)];
        for (int k = 0; k < order.length; k++) {
            set(STRIDE * k, mesh.corner(order[k], 0), mesh.corner(order[k], 1), mesh.corner(order[k], 2));
        }
    }

    private void set(int at, Vector a, Vector b, Vector c) {
        Vector ab = b.minus(a), ac = c.minus(a), n = ab.cross(ac).unit();
        numbers[at] = n.x();
        numbers[at + 1] = n.y();
        numbers[at + 2] = n.z();
        numbers[at + 3] = ab.l1Norm() + ac.l1Norm();
    }

    double nx(int k) {
        return numbers[STRIDE * k];
    }

    double ny(int k) {
        return numbers[STRIDE * k + 1];
    }

    double nz(int k) {
        return numbers[STRIDE * k + 2];
    }

    double edges(int k) {
        return numbers[STRIDE * k + 3];
    }

    double corner(int k, int corner, int axis) {
        return mesh.coordinate(order[k], corner, axis);
    }

    Vector corner(int k, int corner) {
        return mesh.corner(order[k], corner);
    }

    /**
     * What {@link Rounding#planeOffset} takes of a triangle's plane: |x| + |y| + |z| of the first corner, seen from
     * where a ray starts; or less, if that is far beyond where the ray hits the plane.
     */
    double products(Rays rays, int i, int k, double t) {
        double x = corner(k, 0, 0) - rays.ox[i], y = corner(k, 0, 1) - rays.oy[i], z = corner(k, 0, 2) - rays.oz[i];
        double l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        return l1Norm <= FAR * t ? l1Norm : Math.min(l1Norm, productsOfFar(k, x, y, z));
    }

    /** By coordinates: the normal's error is 4u of the magnitudes that its products have, and may be none. */
    double productsOfFar(int k, double x, double y, double z) {
        Vector a = mesh.corner(order[k], 0), e = mesh.corner(order[k], 1).minus(a), f = mesh.corner(order[k], 2).minus(a);
        double length = e.cross(f).dot(new Vector(nx(k), ny(k), nz(k))) / 2;
        return Math.abs(x) * ((Math.abs(e.y() * f.z()) + Math.abs(e.z() * f.y())) / length)
                + Math.abs(y) * ((Math.abs(e.z() * f.x()) + Math.abs(e.x() * f.z())) / length)
                + Math.abs(z) * ((Math.abs(e.x() * f.y()) + Math.abs(e.y() * f.x())) / length);
    }

    /**
     * The distance at which a ray hits a triangle, given that at which it hits its plane; NaN if it misses. A ray
     * that passes all edges on the same side by more than rounding hits. One that rounding cannot tell from an edge
     * does too, if it comes near the triangle: seen edge-on, or beyond the tip of a needle, the edges' sides alone do
     * not tell. The distance then is one inside the triangle's box, by {@link Bvh#room}, so that every search finds it.
     */
    double within(
            Rays rays, Vectors d, int i, int k, double originError, double directionError, double t) {
        double ox = rays.ox[i], oy = rays.oy[i], oz = rays.oz[i];
        Vector way = new Vector(d.x()[i], d.y()[i], d.z()[i]);
        double ax = corner(k, 0, 0) - ox, ay = corner(k, 0, 1) - oy, az = corner(k, 0, 2) - oz;
        double bx = corner(k, 1, 0) - ox, by = corner(k, 1, 1) - oy, bz = corner(k, 1, 2) - oz;
        double cx = corner(k, 2, 0) - ox, cy = corner(k, 2, 1) - oy, cz = corner(k, 2, 2) - oz;
        double ab = side(ax, ay, az, bx, by, bz, way), bc = side(bx, by, bz, cx, cy, cz, way);
        double ca = side(cx, cy, cz, ax, ay, az, way);
        double edges = edges(k), l1Norm = Math.abs(ax) + Math.abs(ay) + Math.abs(az) + edges;
        double margin = Math.min(room, Rounding.edge(originError, directionError, l1Norm, 1)), bound = edges * margin;
        if (!areOnOneSide(ab, bc, ca, bound, bound, bound)) {
            return Double.NaN;
        }
        if (areOnOneSide(ab, bc, ca, -bound, -bound, -bound)) {
            return t;
        }
        Vector terms = d == rays.direction ? rays.directionTerms(i) : null;
        if (terms != null && !areOnOneSide(ab, bc, ca, Math.min(bound, sideError(terms, ax, ay, az, bx, by, bz)),
                Math.min(bound, sideError(terms, bx, by, bz, cx, cy, cz)),
                Math.min(bound, sideError(terms, cx, cy, cz, ax, ay, az)))) {
            return Double.NaN;
        }
        // The sides' sum is the same for all rays that pass within: where it is large, to be on an edge is to be
        // inside.
        return Math.abs(ab + bc + ca) > bound / IN_BOX ? t : inBox(rays, d, i, k, margin, t);
    }

    /** Whether a ray passes all edges on the same side, each within a bound; clearly so, if that is negative. */
    private static boolean areOnOneSide(double ab, double bc, double ca, double abError, double bcError, double caError) {
        return ab >= -abError && bc >= -bcError && ca >= -caError || ab <= abError && bc <= bcError && ca <= caError;
    }

    /** Bounds the error of the side of a ray from the eye, whose direction's terms these are, as {@link #side} has it. */
    private static double sideError(Vector terms, double ax, double ay, double az, double bx, double by, double bz) {
        double x = Math.abs(ax) + Math.abs(bx), y = Math.abs(ay) + Math.abs(by), z = Math.abs(az) + Math.abs(bz);
        return Rounding.eyeEdge(terms.x() * y * z + terms.y() * z * x + terms.z() * x * y);
    }

    /**
     * The distance nearest to t at which a ray is in the triangle's box, widened by a margin; NaN if there is none, or
     * it differs from t by more than t may be off.
     */
    private double inBox(Rays rays, Vectors d, int i, int k, double margin, double t) {
        double near = Double.NEGATIVE_INFINITY, far = Double.POSITIVE_INFINITY;
        double x = d.x()[i], y = d.y()[i], z = d.z()[i];
        for (int axis = 0; axis < 3; axis++) {
            double speed = axis == 0 ? x : axis == 1 ? y : z;
            double from = axis == 0 ? rays.ox[i] : axis == 1 ? rays.oy[i] : rays.oz[i];
            double a = corner(k, 0, axis) - from, b = corner(k, 1, axis) - from, c = corner(k, 2, axis) - from;
            double min = Math.min(a, Math.min(b, c)) - margin, max = Math.max(a, Math.max(b, c)) + margin;
            if (speed != 0) {
                near = Math.max(near, (speed > 0 ? min : max) / speed);
                far = Math.min(far, (speed > 0 ? max : min) / speed);
            } else if (!(min <= 0 && max >= 0)) {
                return Double.NaN;
            }
        }
        double cosine = Math.abs(x * nx(k) + y * ny(k) + z * nz(k));
        double inBox = Math.max(near, Math.min(far, t)), moved = Math.abs(t - inBox);
        return near <= far && moved * cosine <= 2 * margin && (cosine <= GRAZING || moved <= Rounding.TIE_SIEVE / 4 * t)
                ? inBox : Double.NaN;
    }

    /**
     * The side on which a ray passes the edge between two corners: twice direction . (b x a), a and b being the corners
     * seen from the origin, as direction . ((b - a) x (a + b)): the edge is short where the ends are far, so the
     * products are smaller, and round by less. Exchanging a and b changes the sign and nothing else.
     */
    private static double side(double ax, double ay, double az, double bx, double by, double bz, Vector direction) {
        double ex = bx - ax, ey = by - ay, ez = bz - az;
        double sx = ax + bx, sy = ay + by, sz = az + bz;
        return direction.x() * (ey * sz - ez * sy) + direction.y() * (ez * sx - ex * sz)
                + direction.z() * (ex * sy - ey * sx);
    }
}
