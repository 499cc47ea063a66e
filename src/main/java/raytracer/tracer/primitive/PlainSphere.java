package raytracer.tracer.primitive;

import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Workspace;

/**
 * A batch of rays and one sphere: hits and misses that are certain in plain doubles. The other rays are listed in
 * {@link Workspace#doubtful}, for the robust test of {@link Spheres}.
 */
final class PlainSphere {

    // A ray is clear of a sphere if its perpendicular's square exceeds r^2 by this part of it, and the ray's origin is
    // off by no more than this part of r.
    private static final double CLEAR = 1 / 4.0;
    private static final double SHARP = 1 / 32.0;

    private final SphereArray data;
    private final int firstSurface;

    PlainSphere(SphereArray data, int firstSurface) {
        this.data = data;
        this.firstSurface = firstSurface;
    }

    /**
     * Whether a ray is clear of a sphere, without the robust test.
     *
     * @param square r^2 less the square of the perpendicular from the centre: of half the chord, if the ray hits
     * @param error  how far off the ray's origin may be
     */
    static boolean isClear(double square, double radius, double error) {
        return square < -CLEAR * radius * radius && error <= SHARP * radius;
    }

    /** Lists the rays that are not clear of a sphere. */
    void intersect(Rays rays, int k, Workspace workspace, int from, int to) {
        passBy(rays, rays.direction, k, workspace, from, to);
        double radius = data.radius(k);
        int count = 0;
        for (int i = from; i < to; i++) {
            if (!isClear(workspace.square[i], radius, rays.originError[i])) {
                workspace.doubtful[count++] = i;
            }
        }
        workspace.doubtfulCount = count;
    }

    /**
     * Records what rays that start at one point outside a sphere hit for certain, and nearer than all before: what takes
     * long to compute is the same for all.
     *
     * @param power of that point
     */
    void intersectFromEye(Rays rays, int k, double power, Workspace workspace, int from, int to) {
        double x = rays.ox[from] - data.x(k), y = rays.oy[from] - data.y(k), z = rays.oz[from] - data.z(k);
        double r = data.radius(k), l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        passByFromEye(rays, new Vector(x, y, z), r * r, workspace, from, to);
        double[] along = workspace.along, square = workspace.square, t = workspace.distance;
        for (int i = from; i < to; i++) {
            t[i] = power / (Math.sqrt(Math.max(0, square[i])) - along[i]);
        }
        // Whether a ray hits is certain unless the square of half the chord is nearer to 0 than this.
        double doubt = Rounding.sphereSquare(0, Rounding.EYE_DIRECTION, l1Norm, r, l1Norm);
        record(rays, doubt, firstSurface + k, workspace, from, to);
    }

    private static void record(Rays rays, double doubt, int surface, Workspace workspace, int from, int to) {
        double[] distance = rays.distance, along = workspace.along, square = workspace.square, t = workspace.distance;
        int[] hit = rays.hit, doubtful = workspace.doubtful;
        int count = 0;
        for (int i = from; i < to; i++) {
            if (square[i] >= doubt) {
                if (along[i] < 0 && t[i] <= distance[i] * (1 + Rounding.TIE_SIEVE)) {
                    if (t[i] < distance[i] * (1 - Rounding.TIE_SIEVE)) {
                        hit[i] = surface;
                        distance[i] = t[i];
                    } else {
                        doubtful[count++] = i;
                    }
                }
            } else if (square[i] >= -doubt) {
                doubtful[count++] = i;
            }
        }
        workspace.doubtfulCount = count;
    }

    /** Occludes the shadow rays that are blocked for certain. */
    void occlude(Rays rays, ShadowRays shadows, int k, boolean isLightOutside, Workspace workspace, int from, int to) {
        passBy(rays, shadows.direction, k, workspace, from, to);
        double[] square = workspace.square, along = workspace.along, distance = shadows.distance;
        double[] error = shadows.originError;
        boolean[] unoccluded = shadows.unoccluded;
        int[] hit = rays.hit, doubtful = workspace.doubtful;
        double radius = data.radius(k);
        int count = 0;
        for (int i = from; i < to; i++) {
            if (unoccluded[i] && !isClear(square[i], radius, error[i])) {
                boolean behind = along[i] >= 0;
                boolean plain = hit[i] == firstSurface + k ? behind
                        : isLightOutside && isPlain(along[i], square[i], radius, error[i]);
                if (!plain) {
                    doubtful[count++] = i;
                } else if (!behind && -along[i] < distance[i]) {
                    unoccluded[i] = false;
                }
            }
        }
        workspace.doubtfulCount = count;
    }

    /** Whether a ray clearly starts outside a sphere, and hits it clearly or has it behind. */
    private static boolean isPlain(double along, double square, double r, double error) {
        double power = along * along - square;
        return power > error * (2 * r + error) + Rounding.passingPower(along * along, r * r)
                && (along >= 0 || square > 2 * r * Rounding.passing(along, error) + 18 * Rounding.U * r * r);
    }

    /** Lists the shadow rays that go into the sphere on which all start: the others leave it for good. */
    void listInwards(Rays rays, ShadowRays shadows, int k, Workspace workspace, int from, int to) {
        findAlong(rays, shadows.direction, k, workspace.along, from, to);
        int count = 0;
        for (int i = from; i < to; i++) {
            if (workspace.along[i] < 0 && shadows.unoccluded[i]) {
                workspace.doubtful[count++] = i;
            }
        }
        workspace.doubtfulCount = count;
    }

    /** direction . (origin - centre): how far along a ray its origin is from the perpendicular's foot. */
    private void findAlong(Rays rays, Vectors direction, int k, double[] along, int from, int to) {
        double cx = data.x(k), cy = data.y(k), cz = data.z(k);
        double[] ox = rays.ox, oy = rays.oy, oz = rays.oz;
        double[] dx = direction.x(), dy = direction.y(), dz = direction.z();
        for (int i = from; i < to; i++) {
            along[i] = (ox[i] - cx) * dx[i] + (oy[i] - cy) * dy[i] + (oz[i] - cz) * dz[i];
        }
    }

    /** Finds that and r^2 less the perpendicular's square, in {@link Workspace}. */
    private void passBy(Rays rays, Vectors direction, int k, Workspace workspace, int from, int to) {
        findAlong(rays, direction, k, workspace.along, from, to);
        double cx = data.x(k), cy = data.y(k), cz = data.z(k), max = data.radius(k) * data.radius(k);
        double[] ox = rays.ox, oy = rays.oy, oz = rays.oz, along = workspace.along, square = workspace.square;
        double[] dx = direction.x(), dy = direction.y(), dz = direction.z();
        for (int i = from; i < to; i++) {
            double ex = ox[i] - cx - along[i] * dx[i];
            double ey = oy[i] - cy - along[i] * dy[i];
            double ez = oz[i] - cz - along[i] * dz[i];
            square[i] = max - (ex * ex + ey * ey + ez * ez);
        }
    }

    /** The same for rays from one point, as seen from the centre, to the last bit, with half of the arithmetic. */
    private static void passByFromEye(Rays rays, Vector point, double max, Workspace workspace, int from, int to) {
        double x = point.x(), y = point.y(), z = point.z();
        double[] dx = rays.dx, dy = rays.dy, dz = rays.dz, along = workspace.along, square = workspace.square;
        rays.direction.dot(x, y, z, along, from, to);
        for (int i = from; i < to; i++) {
            double ex = x - along[i] * dx[i];
            double ey = y - along[i] * dy[i];
            double ez = z - along[i] * dz[i];
            square[i] = max - (ex * ex + ey * ey + ez * ez);
        }
    }
}
