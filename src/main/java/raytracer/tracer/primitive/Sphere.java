package raytracer.tracer.primitive;

import java.util.Arrays;
import raytracer.scene.Shape;
import raytracer.tracer.arithmetic.PowerOfPoint;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Workspace;

/**
 * A sphere, as rays see it. Whether one hits it is decided by the perpendicular from the centre to the ray, which loses no
 * digits to distance (Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing
 * Gems, 2019, chapter 7); where it does, by the power of the origin, which loses none to size ({@link PowerOfPoint}).
 */
final class Sphere {

    // A ray is clear of a sphere if its perpendicular's square exceeds r^2 by this part of it, and the ray's origin is
    // off by no more than this part of r.
    private static final double CLEAR = 1 / 4.0;
    private static final double SHARP = 1 / 32.0;

    private final int surface;
    private final double cx, cy, cz, r;

    /** No rounding counts beyond this: see {@link raytracer.tracer.bvh.Bvh#room}. */
    private final double maxSquareError;

    Sphere(Shape.Sphere sphere, int surface, double room) {
        this.surface = surface;
        cx = sphere.centre().x();
        cy = sphere.centre().y();
        cz = sphere.centre().z();
        r = sphere.radius();
        maxSquareError = 2 * r * room;
    }

    /** The distance at which a ray hits the sphere; NaN if it does not, or farther away than {@link Rays#maxDistance}. */
    double distance(Rays rays, int i) {
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = rays.dx[i], dy = rays.dy[i], dz = rays.dz[i];
        double along = x * dx + y * dy + z * dz;
        double ex = x - along * dx, ey = y - along * dy, ez = z - along * dz;
        double square = r * r - (ex * ex + ey * ey + ez * ez);
        double l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double originError = rays.originError[i], directionError = rays.directionError[i];
        double bound = Math.min(maxSquareError,
                Rounding.sphereSquare(originError, directionError, l1Norm, r, along));
        if (square < -bound || isClearlyMissed(square, originError)) {
            return Double.NaN;
        }
        double alongError = Rounding.along(originError, directionError, l1Norm);
        double power = rays.source[i] == surface
                ? 0
                : PowerOfPoint.of(rays.ox[i], rays.oy[i], rays.oz[i], cx, cy, cz, r);
        double powerError = Rounding.power(originError, r, rays.slide[i], along);
        if (Math.abs(power) <= powerError) {
            // The ray starts on the sphere: only the other hit counts, if it goes inwards.
            return along < -alongError - rays.slide[i] ? atMost(rays.maxDistance(i), -2 * along) : Double.NaN;
        }
        if (square < bound) {
            double error = Rounding.tangentSquare(along, alongError, power, Rounding.power(originError, r, 0, 0));
            square = error < bound ? along * along - power : square;
            if (square < -Math.min(error, bound)) {
                return Double.NaN;
            }
        }
        return atMost(rays.maxDistance(i), distance(power, along, Math.sqrt(Math.max(0, square))));
    }

    private static double atMost(double max, double t) {
        return t <= max ? t : Double.NaN;
    }

    /**
     * The distance to the first hit, not positive if there is none. The two distances multiply to the power and add
     * up to -2 along; each is computed in the way that subtracts nothing alike.
     */
    private static double distance(double power, double along, double half) {
        if (power > 0) {
            return along < 0 ? power / (half - along) : -1;
        }
        return along <= 0 ? half - along : -power / (half + along);
    }

    /** Bounds the error of that distance. */
    double distanceError(Rays rays, int i, double t) {
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double along = x * rays.dx[i] + y * rays.dy[i] + z * rays.dz[i];
        return Rounding.sphereDistance(rays.originError[i], rays.directionError[i],
                Math.abs(x) + Math.abs(y) + Math.abs(z), r, Math.abs(t + along), along, t);
    }

    /** Records the sphere for rays, from one index to another, that hit it. */
    void intersectAll(Rays rays, int from, int to, Workspace workspace) {
        double[] square = workspace.square;
        rays.direction.dotDifference(rays.origin, cx, cy, cz, workspace.along, from, to);
        squares(rays.origin, rays.direction, workspace.along, square, from, to);
        double power = rays.leaveEye
                ? PowerOfPoint.of(rays.ox[from], rays.oy[from], rays.oz[from], cx, cy, cz, r) : 0;
        if (power > 0) {
            intersectFromEye(rays, from, to, power, workspace);
            return;
        }
        for (int i = from; i < to; i++) {
            if (!isClearlyMissed(r * r - square[i], rays.originError[i])) {
                intersect(rays, i);
            }
        }
    }

    /**
     * The same for rays that start at one point outside: most hit or miss for certain in plain doubles. A clear hit is
     * written here, not by {@link Rays#record}: with that, 266 spheres of 16 samples took 1.06 of their time.
     *
     * @param power of that point
     */
    private void intersectFromEye(Rays rays, int from, int to, double power, Workspace workspace) {
        double l1Norm = Math.abs(rays.ox[from] - cx) + Math.abs(rays.oy[from] - cy) + Math.abs(rays.oz[from] - cz);
        // Whether a ray hits is certain unless the square of half the chord is nearer to 0 than this.
        double doubt = Rounding.sphereSquare(0, Rounding.EYE_DIRECTION, l1Norm, r, l1Norm);
        double[] along = workspace.along, square = workspace.square, near = workspace.half, distance = rays.distance;
        nearDistances(square, along, r * r, power, near, from, to);
        for (int i = from; i < to; i++) {
            double halfSquare = r * r - square[i];
            if (halfSquare < doubt) {
                if (halfSquare >= -doubt) {
                    intersect(rays, i);
                }
            } else if (along[i] < 0) {
                if (near[i] < distance[i] * (1 - Rounding.TIE_SIEVE)) {
                    rays.hit[i] = surface;
                    distance[i] = near[i];
                } else if (near[i] <= distance[i] * (1 + Rounding.TIE_SIEVE)) {
                    rays.record(i, surface, near[i]);
                }
            }
        }
    }

    /** By ray, the distance of the first hit, as {@link #distance} has it; NaN where the ray misses. */
    private static void nearDistances(
            double[] square, double[] along, double radiusSquare, double power, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = power / (Math.sqrt(radiusSquare - square[i]) - along[i]);
        }
    }

    private void intersect(Rays rays, int i) {
        double t = distance(rays, i);
        if (t > 0) {
            rays.record(i, surface, t);
        }
    }

    /** Occludes the shadow rays, from one index to another, that the sphere blocks: most are told in plain doubles. */
    void blockAll(Rays rays, ShadowRays shadows, int from, int to, Workspace workspace) {
        double[] along = workspace.along, square = workspace.square, originError = shadows.originError;
        boolean[] unoccluded = shadows.unoccluded;
        shadows.direction.dotDifference(rays.origin, cx, cy, cz, along, from, to);
        if (!mayBlockAny(rays.hit, unoccluded, along, from, to)) {
            return;
        }
        squares(rays.origin, shadows.direction, along, square, from, to);
        int lightSide = sideOf(shadows.light);
        for (int i = from; i < to; i++) {
            double halfSquare = r * r - square[i];
            if (unoccluded[i] && !isClearlyMissed(halfSquare, originError[i])) {
                boolean isCertain = rays.hit[i] == surface ? along[i] >= 0
                        : lightSide > 0 && isCertain(along[i], halfSquare, originError[i]);
                unoccluded[i] = isCertain ? along[i] >= 0 || -along[i] >= shadows.distance[i]
                        : !blocks(rays, shadows, i, lightSide);
            }
        }
    }

    /** Whether some shadow ray is unoccluded that does not leave the sphere outwards. */
    private boolean mayBlockAny(int[] hit, boolean[] unoccluded, double[] along, int from, int to) {
        for (int i = from; i < to; i++) {
            if (unoccluded[i] && (hit[i] != surface || along[i] < 0)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether the sphere is hit strictly between where a ray has arrived and a light. It follows from which of them are
     * outside, inside and on the sphere, and needs no distance.
     *
     * @param lightSide see {@link #sideOf}
     */
    boolean blocks(Rays rays, ShadowRays shadows, int i, int lightSide) {
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = shadows.dx[i], dy = shadows.dy[i], dz = shadows.dz[i];
        double along = x * dx + y * dy + z * dz;
        double ex = x - along * dx, ey = y - along * dy, ez = z - along * dz;
        double square = r * r - (ex * ex + ey * ey + ez * ez), error = shadows.originError[i];
        if (isClearlyMissed(square, error)) {
            return false;
        }
        double l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double alongError = Rounding.along(rays.originError[i], 2 * Rounding.U, l1Norm) + rays.slide[i];
        int side = 0;
        if (rays.hit[i] != surface) {
            double bound = Math.min(maxSquareError, Rounding.sphereSquare(error, 2 * Rounding.U, l1Norm, r, along));
            double slideAlong = x * rays.dx[i] + y * rays.dy[i] + z * rays.dz[i];
            double powerError = Rounding.power(rays.originError[i], r, rays.slide[i], slideAlong);
            double power = PowerOfPoint.of(rays.ox[i], rays.oy[i], rays.oz[i], cx, cy, cz, r);
            side = sign(power, powerError);
            double tangentError = Rounding.tangentSquare(along, alongError, power, powerError);
            if (square < -bound || side > 0 && square < bound && tangentError < bound
                    && along * along - power < -tangentError) {
                return false;
            }
        }
        if (side == 0) {
            // It must go inwards, and come out again before the light.
            return along < -alongError && lightSide > 0;
        }
        if (side < 0 || lightSide < 0) {
            return side * lightSide < 0;
        }
        // The middle of the way through the sphere must be before the light: clearly so, if the light is on the sphere.
        return along < 0 && -along < shadows.distance[i] - (lightSide > 0 ? 0
                : alongError + Rounding.lightDistance(shadows.light.positionError(), shadows.distance[i]));
    }

    /**
     * Whether a ray passes so far from the sphere that its direction's error does not matter, nor its origin's.
     *
     * @param square r^2 less the square of the perpendicular from the centre: of half the chord, if the ray hits
     * @param error  how far off the ray's origin may be
     */
    private boolean isClearlyMissed(double square, double error) {
        return square < -CLEAR * r * r && error <= SHARP * r;
    }

    /** Whether a ray clearly starts outside a sphere, and hits it clearly or has it behind. */
    private boolean isCertain(double along, double square, double error) {
        double power = along * along - square;
        return power > error * (2 * r + error) + Rounding.passingPower(along * along, r * r)
                && (along >= 0 || square > 2 * r * Rounding.passing(along, error) + 18 * Rounding.U * r * r);
    }

    /** 1 if a light is outside, -1 inside, 0 on the sphere. */
    int sideOf(LightSource light) {
        if (light.directional()) {
            return 1;
        }
        double x = light.x() - cx, y = light.y() - cy, z = light.z() - cz, square = x * x + y * y + z * z;
        double error = Rounding.power(light.positionError(), r, 0, 0);
        // So far outside that what the difference rounds by does not matter.
        if (square - r * r > Math.max(square / 2, 2 * error)) {
            return 1;
        }
        return sign(PowerOfPoint.of(light.x(), light.y(), light.z(), cx, cy, cz, r), error);
    }

    /** 1 if a point is outside a sphere, -1 inside, 0 on it. */
    private static int sign(double power, double error) {
        return Math.abs(power) <= error ? 0 : power > 0 ? 1 : -1;
    }

    /** By ray, the square of the perpendicular from the centre to the ray. */
    private void squares(Vectors origin, Vectors direction, double[] along, double[] out, int from, int to) {
        Arrays.fill(out, from, to, 0);
        addSquare(origin.x(), cx, along, direction.x(), out, from, to);
        addSquare(origin.y(), cy, along, direction.y(), out, from, to);
        addSquare(origin.z(), cz, along, direction.z(), out, from, to);
    }

    private static void addSquare(double[] o, double c, double[] along, double[] d, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            double e = o[i] - c - along[i] * d[i];
            out[i] += e * e;
        }
    }
}
