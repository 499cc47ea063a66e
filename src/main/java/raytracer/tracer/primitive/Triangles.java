package raytracer.tracer.primitive;

import raytracer.scene.Mesh;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/**
 * Triangles. A ray hits one where it hits its plane, if it passes all three edges on the same side. The side of an
 * edge is the sign of direction . (a x b), a and b being the edge's ends seen from the origin: two triangles that share
 * an edge compute the same number for it but for its sign, so no ray slips between them (the argument of Woop, Benthin
 * and Wald, Watertight Ray/Triangle Intersection, JCGT 2013, in the coordinates of Davidovic et al., 3D Rasterization:
 * A Bridge between Rasterization and Ray Casting, 2012). At a corner many edges meet, and their rounded signs may
 * contradict one another so that no triangle is left; therefore a ray that rounding cannot tell from an edge is on it,
 * and hits both sides. A triangle without area has a normal of NaNs, by which every comparison fails: none hits it.
 */
public final class Triangles extends Surfaces {

    public static final int LEAF_SIZE = Bvh.LEAF_SIZE;

    /**
     * Of the bound on the error of an edge's side: a ray that passes two edges on different sides by more is clear of
     * the triangle. More than enough for the sieve's own errors, as the bound is then of the world's origin as an end.
     */
    private static final double SIEVE = 64;

    private final TriangleArray data;
    private final TriangleSieve sieve;

    /** @param bvh of all triangles of the mesh */
    public Triangles(Mesh mesh, int firstSurface, Bvh bvh) {
        super("triangles", firstSurface, bvh);
        data = new TriangleArray(mesh, bvh);
        sieve = new TriangleSieve(mesh, bvh);
    }

    @Override
    protected double distance(Rays rays, int i, int k) {
        if (rays.source[i] == surface(k)) {
            return Double.NaN;
        }
        double ax = data.corner(k, 0, 0) - rays.ox[i], ay = data.corner(k, 0, 1) - rays.oy[i];
        double az = data.corner(k, 0, 2) - rays.oz[i];
        double nx = data.nx(k), ny = data.ny(k), nz = data.nz(k);
        double offset = ax * nx + ay * ny + az * nz;
        double cosine = rays.dx[i] * nx + rays.dy[i] * ny + rays.dz[i] * nz;
        double t = offset / cosine;
        double limit = rays.maxDistance(i);
        if (!(t > 0) || t > limit && Math.abs(cosine) > TriangleArray.GRAZING || isParallel(rays, i, k, cosine)) {
            return Double.NaN;
        }
        double within = data.within(rays, rays.direction, i, k, rays.originError[i], rays.directionError[i], t);
        return within <= limit && startsOff(rays, i, k, ax, ay, az, offset) ? within : Double.NaN;
    }

    /** Whether rounding hides on which side a ray approaches a triangle's plane. */
    private boolean isParallel(Rays rays, int i, int k, double cosine) {
        if (Math.abs(cosine) > Rounding.cosine(rays.directionError[i])) {
            return false;
        }
        Vector d = rays.directionTerms(i);
        return d == null || Math.abs(cosine) <= Rounding.eyeCosine(data.productsOfFar(k, d.x(), d.y(), d.z()));
    }

    /** Whether a ray clearly does not start on a triangle's plane, which is off by this as seen from there. */
    private boolean startsOff(Rays rays, int i, int k, double x, double y, double z, double offset) {
        double cosine = rays.dx[i] * data.nx(k) + rays.dy[i] * data.ny(k)
                + rays.dz[i] * data.nz(k);
        double error = rays.originError[i] + rays.slide[i] * Math.abs(cosine);
        return Math.abs(offset) > Rounding.planeOffset(error, Math.abs(x) + Math.abs(y) + Math.abs(z))
                || Math.abs(offset) > Rounding.planeOffset(error, data.productsOfFar(k, x, y, z));
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
     * Computes for all rays the least product of two edges' sides, in {@link Workspace#minProduct}: negative where a
     * ray passes edges on different sides. The sides are those of {@link #within}, but from the rays' moments about
     * the world's origin (Pluecker coordinates), for which the triangle's part is the same for all. That may lose
     * digits, and is only a first sieve.
     *
     * @return rays are clear of the triangle if they have less than this
     */
    private double passBy(Vectors d, int from, int to, int k, Workspace workspace) {
        Vector a = data.corner(k, 0);
        double[][] sides = {workspace.sides.x(), workspace.sides.y(), workspace.sides.z()};
        for (int edge = 0; edge < 3; edge++) {
            Vector b = data.corner(k, (edge + 1) % 3);
            sides(a, b, d, workspace.moment, sides[edge], from, to);
            a = b;
        }
        double[] ab = sides[0], bc = sides[1], ca = sides[2], product = workspace.minProduct;
        for (int i = from; i < to; i++) {
            // May overflow or be lost, and then is not less than what it is compared with.
            product[i] = Math.min(ab[i] * bc[i], Math.min(bc[i] * ca[i], ca[i] * ab[i]));
        }
        double edges = data.edges(k);
        double l1Norm = a.l1Norm() + edges + workspace.farthest;
        double max = 4 * edges * l1Norm;
        return -max * SIEVE * Rounding.edge(workspace.originError, workspace.directionError, l1Norm, edges);
    }

    /** By ray, the side of the edge e from a to b, of sum s: d . (e x s) - 2 e . m. */
    private static void sides(Vector a, Vector b, Vectors d, Vectors m, double[] out, int from, int to) {
        double ex = b.x() - a.x(), ey = b.y() - a.y(), ez = b.z() - a.z();
        double sx = a.x() + b.x(), sy = a.y() + b.y(), sz = a.z() + b.z();
        d.dot(ey * sz - ez * sy, ez * sx - ex * sz, ex * sy - ey * sx, out, from, to);
        m.addDot(-2 * ex, -2 * ey, -2 * ez, out, from, to);
    }

    @Override
    protected double distanceError(Rays rays, int i, int k, double t) {
        double cosine = rays.dx[i] * data.nx(k) + rays.dy[i] * data.ny(k) + rays.dz[i] * data.nz(k);
        return Rounding.planeDistance(
                rays.originError[i], rays.directionError[i], data.products(rays, i, k, t), t, cosine);
    }

    @Override
    public boolean blocks(Rays rays, ShadowRays shadows, int i, int k) {
        if (rays.hit[i] == surface(k)) {
            return false;
        }
        double x = data.corner(k, 0, 0) - rays.ox[i], y = data.corner(k, 0, 1) - rays.oy[i];
        double z = data.corner(k, 0, 2) - rays.oz[i];
        double nx = data.nx(k), ny = data.ny(k), nz = data.nz(k);
        double offset = x * nx + y * ny + z * nz;
        double cosine = shadows.dx[i] * nx + shadows.dy[i] * ny + shadows.dz[i] * nz;
        // In front of the ray, and the ray's line passes within. What is beyond the light comes last, as the rarest.
        return (offset > 0 && cosine > 0 || offset < 0 && cosine < 0)
                && Math.abs(cosine) > Rounding.cosine(2 * Rounding.U)
                && data.within(rays, shadows.direction, i, k, shadows.originError[i], 2 * Rounding.U,
                        offset / cosine) > 0
                && startsOff(rays, i, k, x, y, z, offset)
                && isBeforeLight(shadows.light, k, offset);
    }

    /** Whether the plane of a triangle has the light on the other side than the point with this offset. */
    private boolean isBeforeLight(LightSource light, int k, double offset) {
        if (light.directional()) {
            return true;
        }
        double x = data.corner(k, 0, 0) - light.x(), y = data.corner(k, 0, 1) - light.y();
        double z = data.corner(k, 0, 2) - light.z();
        double lightOffset = x * data.nx(k) + y * data.ny(k) + z * data.nz(k);
        double bound = Rounding.planeOffset(light.positionError(), Math.abs(x) + Math.abs(y) + Math.abs(z));
        return offset > 0 ? lightOffset < -bound : lightOffset > bound;
    }

    @Override
    public void moveToHits(Rays rays, int from, int to, Workspace workspace) {
        for (int i = from; i < to; i++) {
            moveToHit(rays, i, number(rays.hit[i]));
        }
    }

    private void moveToHit(Rays rays, int i, int k) {
        rays.moveToPlane(i, data.products(rays, i, k, rays.distance[i]), data.nx(k), data.ny(k), data.nz(k));
    }
}
