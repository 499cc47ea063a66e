package raytracer.tracer.primitive;

import raytracer.scene.Mesh;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.RayIntervals;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.LineBundle;
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

    public static final int LEAF_SIZE = 4;

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
        LineBundle lines = workspace.lines;
        lines.setErrors(LineBundle.max(rays.originError, from, to), LineBundle.max(rays.directionError, from, to));
        if (rays.leaveEye) {
            lines.setMeeting(rays.origin.get(from), rays.origin, rays.direction, from, to);
        } else {
            lines.setSkew(rays.origin, rays.direction, from, to);
        }
    }

    @Override
    public void prepareToBlock(Rays rays, ShadowRays shadows, int from, int to, Workspace workspace) {
        LineBundle lines = workspace.lines;
        LightSource light = shadows.light;
        Vector v = new Vector(light.x(), light.y(), light.z());
        lines.setErrors(LineBundle.max(shadows.originError, from, to), 2 * Rounding.U);
        if (light.directional()) {
            lines.setParallel(v, rays.origin, from, to);
        } else {
            lines.setMeeting(v, rays.origin, shadows.direction, from, to);
        }
    }

    @Override
    public int sift(RayIntervals rays, int[] numbers, int count, Workspace workspace) {
        LineBundle lines = workspace.lines;
        if (!lines.areAlike()) {
            return count;
        }
        lines.setIntervals(rays);
        int kept = 0;
        for (int n = 0; n < count; n++) {
            int k = numbers[n];
            if (lines.mayHit(data.corner(k, 0), data.corner(k, 1), data.corner(k, 2), data.edges(k))) {
                numbers[kept++] = k;
            }
        }
        return kept;
    }

    private float measure(int from, int to, int k, Workspace workspace) {
        return workspace.lines.measure(
                data.corner(k, 0), data.corner(k, 1), data.corner(k, 2), data.edges(k), from, to);
    }

    @Override
    public void intersectAll(Rays rays, int from, int to, int k, Workspace workspace) {
        float clear = measure(from, to, k, workspace);
        float[] clearance = workspace.lines.clearance;
        for (int i = from; i < to; i++) {
            if (!(clearance[i] > clear)) {
                intersect(rays, i, k);
            }
        }
    }

    @Override
    public void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Workspace workspace) {
        float clear = measure(from, to, k, workspace);
        float[] clearance = workspace.lines.clearance;
        for (int i = from; i < to; i++) {
            if (!(clearance[i] > clear) && shadows.unoccluded[i]) {
                shadows.unoccluded[i] = !blocks(rays, shadows, i, k);
            }
        }
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
