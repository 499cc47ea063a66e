package raytracer.tracer.primitive;

import java.util.concurrent.ForkJoinPool;
import raytracer.scene.Mesh;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bounds;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.ParallelRange;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.lightbuffer.Viewpoints;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;

/**
 * Triangles. A ray hits one where it hits its plane, if it passes all three edges on the same side. The side of an
 * edge is the sign of direction . (a x b), a and b being the edge's ends seen from the origin: two triangles that share
 * an edge compute the same number for it but for its sign, so no ray slips between them (the argument of Woop, Benthin
 * and Wald, Watertight Ray/Triangle Intersection, JCGT 2013, in the coordinates of Davidovic et al., 3D Rasterization:
 * A Bridge between Rasterization and Ray Casting, 2012). At a corner many edges meet, and their rounded signs may
 * contradict one another so that no triangle is left; therefore a ray that rounding cannot tell from an edge is on it,
 * and hits both sides. A triangle without area has a normal of NaNs, by which every comparison fails: none hits it.
 */
public final class Triangles extends BoundedSurfaces {

    public static final int LEAF_SIZE = Bvh.LEAF_SIZE;

    private static final int STRIDE = 4;

    /**
     * Of the bound on the error of an edge's side: a ray that passes two edges on different sides by more is clear of
     * the triangle. More than enough for the sieve's own errors, as the bound is then of the world's origin as an end.
     */
    private static final double SIEVE = 64;

    /**
     * A ray whose cosine with a triangle's normal is greater hits the triangle's plane at a distance that is exact
     * enough to be compared with others at once: off by less than {@link Rounding#TIE_SIEVE}.
     */
    private static final double GRAZING = 0x1p-16;

    /**
     * Of a triangle's size: so far beside it a hit is in its box all the same, as boxes are enlarged by more
     * ({@link Bvh#PADDING}, of which this needs v).
     */
    private static final double IN_BOX = 0x1p-26;

    /** Of the distance at which a ray hits a triangle's plane: a corner farther away than this is far. */
    private static final double FAR = 16;

    private final Mesh mesh;
    /** By a triangle's number among these: its number in the mesh. */
    private final int[] order;
    /** By triangle: the unit normal; then |x| + |y| + |z| of two edges, summed: no edge is longer. */
    private final double[] data;
    private final TriangleSieve sieve;

    /** @param bvh of all triangles of the mesh */
    public Triangles(Mesh mesh, int firstSurface, Bvh bvh, Viewpoints viewpoints, ForkJoinPool pool) {
        super("triangles", firstSurface, bvh, viewpoints);
        this.mesh = mesh;
        order = bvh.order();
        data = new double[Math.multiplyExact(STRIDE, order.length)];
        sieve = new TriangleSieve(mesh, bvh);
        ParallelRange.run(pool, 0, order.length, (from, to) -> {
            for (int k = from; k < to; k++) {
                setData(k);
                sieve.set(k);
            }
        });
    }

    private void setData(int k) {
        Vector a = mesh.corner(order[k], 0);
        Vector ab = mesh.corner(order[k], 1).minus(a), ac = mesh.corner(order[k], 2).minus(a);
        Vector n = ab.cross(ac).unit();
        data[STRIDE * k] = n.x();
        data[STRIDE * k + 1] = n.y();
        data[STRIDE * k + 2] = n.z();
        data[STRIDE * k + 3] = Math.abs(ab.x()) + Math.abs(ab.y()) + Math.abs(ab.z())
                + Math.abs(ac.x()) + Math.abs(ac.y()) + Math.abs(ac.z());
    }

    private double nx(int k) {
        return data[STRIDE * k];
    }

    private double ny(int k) {
        return data[STRIDE * k + 1];
    }

    private double nz(int k) {
        return data[STRIDE * k + 2];
    }

    private double edges(int k) {
        return data[STRIDE * k + 3];
    }

    private double corner(int k, int corner, int axis) {
        return mesh.coordinate(order[k], corner, axis);
    }

    public static Bounds bounds(Mesh mesh) {
        return (k, box) -> {
            for (int axis = 0; axis < 3; axis++) {
                double a = mesh.coordinate(k, 0, axis);
                double b = mesh.coordinate(k, 1, axis);
                double c = mesh.coordinate(k, 2, axis);
                box[axis] = Math.min(a, Math.min(b, c));
                box[axis + 3] = Math.max(a, Math.max(b, c));
            }
        };
    }

    @Override
    public Vector corner(int k, int corner) {
        return mesh.corner(order[k], corner);
    }

    /** None: a triangle bounds itself. */
    @Override
    public double radius(int k) {
        return 0;
    }

    @Override
    double distance(Rays rays, int i, int k) {
        if (rays.source[i] == surface(k)) {
            return Double.NaN;
        }
        double ax = corner(k, 0, 0) - rays.ox[i], ay = corner(k, 0, 1) - rays.oy[i], az = corner(k, 0, 2) - rays.oz[i];
        double nx = nx(k), ny = ny(k), nz = nz(k);
        double offset = ax * nx + ay * ny + az * nz;
        double cosine = rays.dx[i] * nx + rays.dy[i] * ny + rays.dz[i] * nz;
        double t = offset / cosine;
        double limit = rays.maxDistance(i);
        if (!(t > 0) || t > limit && (Math.abs(cosine) > GRAZING || isBeyond(rays, i, ax, ay, az, t - limit, cosine))
                || Math.abs(cosine) <= Rounding.cosine(rays.directionError[i])) {
            return Double.NaN;
        }
        double within = within(rays, rays.direction, i, k, rays.originError[i], rays.directionError[i], t);
        return within <= limit && startsOff(rays, i, k, ax, ay, az, offset) ? within : Double.NaN;
    }

    /** Whether a ray clearly does not start on a triangle's plane, which is off by this as seen from there. */
    private boolean startsOff(Rays rays, int i, int k, double x, double y, double z, double offset) {
        double cosine = rays.dx[i] * nx(k) + rays.dy[i] * ny(k)
                + rays.dz[i] * nz(k);
        double error = rays.originError[i] + rays.slide[i] * Math.abs(cosine);
        return Math.abs(offset) > Rounding.planeOffset(error, Math.abs(x) + Math.abs(y) + Math.abs(z))
                || Math.abs(offset) > Rounding.planeOffset(error, productsOfFar(k, x, y, z));
    }

    /** Whether a distance is too great by more than its error. */
    private static boolean isBeyond(
            Rays rays, int i, double ax, double ay, double az, double beyond, double cosine) {
        double cosineError = Rounding.cosine(rays.directionError[i]);
        return beyond * (Math.abs(cosine) - cosineError) > rays.maxDistance(i) * cosineError
                + Rounding.planeOffset(rays.originError[i], Math.abs(ax) + Math.abs(ay) + Math.abs(az));
    }

    @Override
    public boolean hasSieve() {
        return true;
    }

    @Override
    public int mayHit(int first, int end, Workspace workspace) {
        return sieve.mayHit(workspace.line, first, end);
    }

    @Override
    public void prepareToIntersect(Rays rays, int from, int to, Workspace workspace) {
        workspace.directionError = rays.leaveEye ? Rounding.EYE_DIRECTION : max(rays.directionError, from, to);
        prepare(rays, rays.direction, rays.originError, from, to, workspace);
    }

    @Override
    public void prepareToBlock(Rays rays, ShadowRays shadows, int from, int to, Workspace workspace) {
        workspace.directionError = 2 * Rounding.U;
        prepare(rays, shadows.direction, shadows.originError, from, to, workspace);
    }

    private static void prepare(Rays rays, Vectors d, double[] originError, int from, int to, Workspace workspace) {
        Vectors.cross(rays.origin, d, workspace.moment, from, to);
        workspace.farthest = max(rays.ox, from, to) + max(rays.oy, from, to) + max(rays.oz, from, to);
        workspace.originError = max(originError, from, to);
    }

    private static double max(double[] values, int from, int to) {
        double max = 0;
        for (int i = from; i < to; i++) {
            max = Math.max(max, Math.abs(values[i]));
        }
        return max;
    }

    @Override
    public void intersectAll(Rays rays, int from, int to, int k, Workspace workspace) {
        double clear = passBy(rays.direction, from, to, k, workspace);
        double[] product = workspace.minProduct;
        for (int i = from; i < to; i++) {
            if (!(product[i] < clear)) {
                intersect(rays, i, k);
            }
        }
    }

    @Override
    public void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Workspace workspace) {
        double clear = passBy(shadows.direction, from, to, k, workspace);
        double[] product = workspace.minProduct;
        for (int i = from; i < to; i++) {
            if (shadows.unoccluded[i] && !(product[i] < clear)) {
                shadows.unoccluded[i] = !blocks(rays, shadows, i, k);
            }
        }
    }

    /**
     * Computes for all rays the least product of two edges' sides, in {@link Workspace#minProduct}: negative where a ray
     * passes edges on different sides. The sides are those of {@link #within}, but from the rays' moments about
     * the world's origin (Pluecker coordinates), for which the triangle's part is the same for all. That may lose
     * digits, and is only a first sieve.
     *
     * @return rays are clear of the triangle if they have less than this
     */
    private double passBy(Vectors d, int from, int to, int k, Workspace workspace) {
        double[] ab = workspace.sides.x(), bc = workspace.sides.y(), ca = workspace.sides.z();
        sides(k, 0, 1, d, ab, from, to, workspace);
        sides(k, 1, 2, d, bc, from, to, workspace);
        sides(k, 2, 0, d, ca, from, to, workspace);
        Kernel.run(new MinProduct(ab, bc, ca, workspace.minProduct), from, to);
        double edges = difference(k, 0, 1) + difference(k, 0, 2);
        double l1Norm = Math.abs(corner(k, 0, 0)) + Math.abs(corner(k, 0, 1)) + Math.abs(corner(k, 0, 2)) + edges
                + workspace.farthest;
        double max = 4 * edges * l1Norm;
        return -max * SIEVE * Rounding.edge(workspace.originError, workspace.directionError, l1Norm, edges);
    }

    /** |x| + |y| + |z| of the edge between two corners. */
    private double difference(int k, int a, int b) {
        return Math.abs(corner(k, a, 0) - corner(k, b, 0)) + Math.abs(corner(k, a, 1) - corner(k, b, 1))
                + Math.abs(corner(k, a, 2) - corner(k, b, 2));
    }

    /** By ray, the side of the edge e between two corners of sum s: d . (e x s) - 2 e . m. */
    private void sides(int k, int a, int b, Vectors d, double[] out, int from, int to, Workspace workspace) {
        double ax = corner(k, a, 0), ay = corner(k, a, 1), az = corner(k, a, 2);
        double bx = corner(k, b, 0), by = corner(k, b, 1), bz = corner(k, b, 2);
        double ex = bx - ax, ey = by - ay, ez = bz - az;
        double sx = ax + bx, sy = ay + by, sz = az + bz;
        // In one loop it would be too much for C2 to vectorise, see Kernel.
        Kernel.run(new Kernel.DotWith(ey * sz - ez * sy, ez * sx - ex * sz, ex * sy - ey * sx, d, out), from, to);
        Kernel.run(new Kernel.AddDotWith(-2 * ex, -2 * ey, -2 * ez, workspace.moment, out), from, to);
    }

    /** out = min(a b, b c, c a); may overflow or be lost, and then is not less than what it is compared with. */
    private record MinProduct(double[] a, double[] b, double[] c, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = Math.min(a[i] * b[i], Math.min(b[i] * c[i], c[i] * a[i]));
            }
        }
    }

    @Override
    double distanceError(Rays rays, int i, int k, double t) {
        double cosine = rays.dx[i] * nx(k) + rays.dy[i] * ny(k) + rays.dz[i] * nz(k);
        return Rounding.planeDistance(
                rays.originError[i], rays.directionError[i], products(rays, i, k, t), t, cosine);
    }

    /**
     * What {@link Rounding#planeOffset} takes of a triangle's plane: |x| + |y| + |z| of the first corner, seen from
     * where a ray starts; or less, if that is far beyond where the ray hits the plane.
     */
    private double products(Rays rays, int i, int k, double t) {
        double x = corner(k, 0, 0) - rays.ox[i], y = corner(k, 0, 1) - rays.oy[i], z = corner(k, 0, 2) - rays.oz[i];
        double l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        return l1Norm <= FAR * t ? l1Norm : Math.min(l1Norm, productsOfFar(k, x, y, z));
    }

    /** By coordinates: the normal's error is 4u of the magnitudes that its products have, and may be none. */
    private double productsOfFar(int k, double x, double y, double z) {
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
     * not tell. The distance then is one inside the triangle's box, so that no search overlooks it.
     */
    private double within(
            Rays rays, Vectors d, int i, int k, double originError, double directionError, double t) {
        double ox = rays.ox[i], oy = rays.oy[i], oz = rays.oz[i];
        double dx = d.x()[i], dy = d.y()[i], dz = d.z()[i];
        double ax = corner(k, 0, 0) - ox, ay = corner(k, 0, 1) - oy, az = corner(k, 0, 2) - oz;
        double bx = corner(k, 1, 0) - ox, by = corner(k, 1, 1) - oy, bz = corner(k, 1, 2) - oz;
        double cx = corner(k, 2, 0) - ox, cy = corner(k, 2, 1) - oy, cz = corner(k, 2, 2) - oz;
        double ab = side(ax, ay, az, bx, by, bz, dx, dy, dz);
        double bc = side(bx, by, bz, cx, cy, cz, dx, dy, dz);
        double ca = side(cx, cy, cz, ax, ay, az, dx, dy, dz);
        double edges = edges(k);
        double margin = Rounding.edge(
                originError, directionError, Math.abs(ax) + Math.abs(ay) + Math.abs(az) + edges, 1);
        double bound = edges * margin;
        if (!(ab >= -bound && bc >= -bound && ca >= -bound || ab <= bound && bc <= bound && ca <= bound)) {
            return Double.NaN;
        }
        // The sides' sum is the same for all rays that pass within: where it is large, to be on an edge is to be inside.
        boolean isInBox = Math.abs(ab + bc + ca) > bound / IN_BOX
                || ab > bound && bc > bound && ca > bound || ab < -bound && bc < -bound && ca < -bound;
        return isInBox ? t : inBox(rays, d, i, k, margin, t);
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
     * Twice direction . (a x b), as direction . ((b - a) x (a + b)): the edge is short where the ends are far, so the
     * products are smaller, and round by less. Exchanging a and b changes the sign and nothing else.
     */
    private static double side(double ax, double ay, double az, double bx, double by, double bz,
            double dx, double dy, double dz) {
        double ex = bx - ax, ey = by - ay, ez = bz - az;
        double sx = ax + bx, sy = ay + by, sz = az + bz;
        return dx * (ey * sz - ez * sy) + dy * (ez * sx - ex * sz) + dz * (ex * sy - ey * sx);
    }

    @Override
    public boolean blocks(Rays rays, ShadowRays shadows, int i, int k) {
        if (rays.hit[i] == surface(k)) {
            return false;
        }
        double x = corner(k, 0, 0) - rays.ox[i], y = corner(k, 0, 1) - rays.oy[i], z = corner(k, 0, 2) - rays.oz[i];
        double nx = nx(k), ny = ny(k), nz = nz(k);
        double offset = x * nx + y * ny + z * nz;
        double cosine = shadows.dx[i] * nx + shadows.dy[i] * ny + shadows.dz[i] * nz;
        // In front of the ray, and the ray's line passes within. What is beyond the light comes last, as the rarest.
        return (offset > 0 && cosine > 0 || offset < 0 && cosine < 0)
                && Math.abs(cosine) > Rounding.cosine(2 * Rounding.U)
                && within(rays, shadows.direction, i, k, shadows.originError[i], 2 * Rounding.U,
                        offset / cosine) > 0
                && startsOff(rays, i, k, x, y, z, offset)
                && isBeforeLight(shadows.light, k, offset);
    }

    /** Whether the plane of a triangle has the light on the other side than the point with this offset. */
    private boolean isBeforeLight(LightSource light, int k, double offset) {
        if (light.directional()) {
            return true;
        }
        double x = corner(k, 0, 0) - light.x(), y = corner(k, 0, 1) - light.y(), z = corner(k, 0, 2) - light.z();
        double lightOffset = x * nx(k) + y * ny(k) + z * nz(k);
        double bound = Rounding.planeOffset(light.positionError(), Math.abs(x) + Math.abs(y) + Math.abs(z));
        return offset > 0 ? lightOffset < -bound : lightOffset > bound;
    }

    @Override
    public boolean isOfOneSurface() {
        return true;
    }

    @Override
    public Kernel moving(Rays rays, Workspace workspace) {
        return (from, to) -> {
            for (int i = from; i < to; i++) {
                moveToHit(rays, i, number(rays.hit[i]));
            }
        };
    }

    private void moveToHit(Rays rays, int i, int k) {
        rays.moveToPlane(i, products(rays, i, k, rays.distance[i]), nx(k), ny(k), nz(k));
    }
}
