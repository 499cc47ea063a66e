package raytracer.tracer.primitive;

import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Workspace;

/**
 * Hits and misses of a sphere that are certain in plain doubles; the rest goes to the robust test of {@link Spheres}.
 */
public final class PlainSphere {

    // A ray is clear of a sphere if its perpendicular's square exceeds r^2 by this part of it, and the ray's origin is
    // off by no more than this part of r.
    private static final double CLEAR = 1 / 4.0;
    private static final double SHARP = 1 / 32.0;

    private PlainSphere() { }

    /**
     * Whether a ray is clear of a sphere, without the robust test.
     *
     * @param square r^2 less the square of the perpendicular from the centre: of half the chord, if the ray hits
     * @param error  how far off the ray's origin may be
     */
    static boolean isClear(double square, double radius, double error) {
        return square < -CLEAR * radius * radius && error <= SHARP * radius;
    }

    /**
     * Records hits that are certain, and nearer than all before; lists the rays for the robust test.
     *
     * @param doubt whether a ray hits is certain unless the square of half the chord is nearer to 0 than this
     */
    static void record(Rays rays, double doubt, int surface, Workspace workspace, int from, int to) {
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

    /**
     * Occludes the shadow rays that are blocked for certain; lists the rays for the robust test.
     *
     * @param radius   of the sphere
     * @param lightSide 1 if the light is outside of it, -1 inside, 0 on it
     */
    static void occlude(Rays rays, ShadowRays shadows, double radius, int surface, boolean isLightOutside,
            Workspace workspace, int from, int to) {
        double[] square = workspace.square, along = workspace.along, distance = shadows.distance;
        double[] error = shadows.originError;
        boolean[] unoccluded = shadows.unoccluded;
        int[] hit = rays.hit, doubtful = workspace.doubtful;
        int count = 0;
        for (int i = from; i < to; i++) {
            if (unoccluded[i] && !isClear(square[i], radius, error[i])) {
                boolean behind = along[i] >= 0;
                boolean plain = hit[i] == surface ? behind : isLightOutside
                        && isPlain(along[i], square[i], radius, error[i]);
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
}
