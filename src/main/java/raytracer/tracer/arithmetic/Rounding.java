package raytracer.tracer.arithmetic;

/**
 * Bounds on the rounding errors of the tracer's arithmetic. They take the place of epsilons: each grows with the
 * numbers that entered a computation, so a scene scaled by a power of two is decided in the same way, bit for bit.
 * First-order analysis after Higham, Accuracy and Stability of Numerical Algorithms (2002), chapter 3, and pbrt-v4,
 * section 6.8; u is the unit roundoff and second-order terms are covered by rounding the factors up.
 */
public final class Rounding {

    /** The unit roundoff of double: half the distance from 1 to the next. */
    public static final double U = 0x1p-53;

    /** The square root of 3, rounded up: how far a point can be when each coordinate is off by at most 1. */
    private static final double DIAGONAL = 1.7320508075688774;

    /**
     * Relative to the distance: hits closer to one another than this may be a tie, which is decided by the
     * bounds on their errors. It is more than twice {@link #MAX_TIE}, so that none is overlooked.
     */
    public static final double TIE_SIEVE = 0x1p-20;

    /**
     * Relative to the distance: a greater error is not granted to a hit that is compared with others. Only hits that
     * graze by less than a millionth of a radian have one.
     */
    private static final double MAX_TIE = 0x1p-22;

    /**
     * Relative to the distance: a point is not taken to be off by more along the ray that came there. Only rays that graze
     * by less than 1e-4 could be, and along what they graze a bound that is too wide is as wrong as one too narrow: this is
     * 1e-7 of a pixel, of 1,000 in a view of 10 degrees. How far they are off what they graze is kept apart.
     */
    private static final double MAX_SLIDE = 0x1p-36;

    /** A mirror is not taken to turn a ray by more than this beside its true way, as the limb of a sphere does. */
    private static final double MAX_TURN = 0x1p-24;

    /** Bounds the error of each coordinate of a ray from the eye: scaled basis, products, sums and normalising. */
    public static final double EYE_DIRECTION = 5 * U;

    private Rounding() { }

    /** Bounds the error of a distance for comparing it with others. */
    public static double tie(double distanceError, double distance) {
        return Math.min(distanceError, MAX_TIE * distance);
    }

    /**
     * Bounds the error of (point - origin) . normal, a unit normal: differences, the normal, products and sums round by
     * 5u of the products' magnitudes.
     *
     * @param originError how far off the origin may be
     * @param products    |x nx| + |y ny| + |z nz| of point - origin, or more
     */
    public static double planeOffset(double originError, double products) {
        return originError + 5 * U * products;
    }

    /**
     * Bounds the error of direction . normal, of unit vectors: 4u from the normal, products and sums, and the
     * direction's own. A ray whose cosine is not above it counts as parallel to the plane: not even the sign is known.
     *
     * @param directionError of each coordinate of the direction
     */
    public static double cosine(double directionError) {
        return DIAGONAL * directionError + 4 * U;
    }

    /**
     * Bounds the error of direction . normal of a ray from the eye, by its terms: less than {@link #cosine} where these are
     * small, as for a ray along a floor that is level.
     *
     * @param terms the sum over all coordinates of the magnitudes that direction and normal are sums of, multiplied
     */
    public static double eyeCosine(double terms) {
        return (EYE_DIRECTION + 4 * U) * terms;
    }

    /**
     * Bounds the error of the distance at which a ray hits a plane: that of the offset, and the distance times that of
     * the cosine, both divided by the cosine.
     */
    public static double planeDistance(
            double originError, double directionError, double products, double distance, double cosine) {
        return (planeOffset(originError, products) + distance * cosine(directionError)) / Math.abs(cosine);
    }

    /**
     * Bounds how far a computed point, origin + distance * direction, is from the ray that it is meant to be on: the
     * direction's own error, as it leaves the eye, and 2u of the distance and u of the point from product and sum.
     * How far the point may be off along the ray is the distance's error, which is kept apart: a grazing ray has a
     * large one, which does not bring the point nearer to anything that is parallel to the ray.
     *
     * @param position |x| + |y| + |z| of the computed point
     */
    public static double point(double distance, double position) {
        return U * (13 * distance + position);
    }

    /**
     * Bounds how far off a plane is a point where a ray has hit it, which is that over the cosine along the ray.
     *
     * @param products as for {@link #planeOffset}
     */
    public static double planeSink(double products, double distance) {
        return planeOffset(0, products) + distance * cosine(EYE_DIRECTION);
    }

    /** A bound on how far off a point is along the ray that came there, as far as it is granted. */
    public static double slide(double bound, double distance) {
        return Math.min(bound, MAX_SLIDE * distance);
    }

    /** Bounds the error that a mirror adds to each coordinate of a direction, as far as it is granted. */
    public static double turn(double normalError) {
        return Math.min(4 * normalError, MAX_TURN) + 4 * U;
    }

    /**
     * Bounds the error of direction . (edge x (a + b)), a and b being the edge's ends seen from the origin: the ends
     * round by u and the sum by 2u of their distance, products and sums by 6u of theirs times the edge, all of it twice
     * at most; where the ray is off by some length, the result is by that times twice the edge. Of rays that pass as near to
     * the edge as it is long: of others the edge's own rounding counts for more, and the sign is beyond doubt.
     *
     * @param l1Norm |x| + |y| + |z| of the farther end
     * @param edge  |x| + |y| + |z| of the edge, or more
     */
    public static double edge(double originError, double directionError, double l1Norm, double edge) {
        return edge * (24 * U * l1Norm + 2 * (originError + DIAGONAL * directionError * l1Norm));
    }

    /**
     * Bounds the error of the same number of a ray from the eye, by its terms: edge and sum are off by 2u of the sums of
     * both ends' magnitudes, their products by 5u, a difference of two by 6u, times the direction by 12u, and the sum of
     * three by 14u of its terms, which are two for each coordinate.
     *
     * @param terms the sum over all coordinates of the magnitudes that the direction is the sum of, times those of both
     *              ends along the other two axes
     */
    public static double eyeEdge(double terms) {
        return 32 * U * terms;
    }

    /**
     * Bounds the error of the power of an origin near a sphere, |origin - centre|^2 - r^2, due to the origin's errors.
     *
     * @param slide how far the origin may be off along some direction
     * @param along that direction . (origin - centre)
     */
    public static double power(double originError, double radius, double slide, double along) {
        return 2 * (radius * originError + slide * Math.abs(along)) + slide * slide;
    }

    /**
     * Bounds the error of the power of a ray's origin as it is computed from (direction . (origin - centre))^2 and
     * r^2 - p^2, p being the perpendicular from the centre to the ray: 22u of |origin - centre|^2 from the first, 40u
     * from the second and 4u from the direction's length; p^2 is at most 5/4 r^2.
     */
    public static double passingPower(double alongSquare, double radiusSquare) {
        return 96 * U * (alongSquare + radiusSquare);
    }

    /**
     * Bounds by how much a ray is off where it passes a sphere, but for 9u of the radius: {@link #sphereSquare} over
     * 2 r, of rays whose perpendicular is not much longer than r.
     *
     * @param along direction . (origin - centre)
     */
    public static double passing(double along, double originError) {
        return originError + 9 * U * Math.abs(along);
    }

    /**
     * Bounds the error of direction . (origin - centre): 3u of the offset, and the errors of both.
     *
     * @param l1Norm |x| + |y| + |z| of origin - centre
     */
    public static double along(double originError, double directionError, double l1Norm) {
        return (3 * U + directionError) * l1Norm + originError;
    }

    /**
     * Bounds the error of r^2 - p^2, p being the perpendicular from the centre to the ray: each of its coordinates
     * rounds by 3u of the offset and is off as the ray is at its foot, so the difference is off by 2r times that and
     * 2u r^2. (As far as r and p are alike: where they are not, the sign is beyond doubt.)
     */
    public static double sphereSquare(
            double originError, double directionError, double l1Norm, double radius, double along) {
        double foot = originError + DIAGONAL * directionError * Math.abs(along);
        return 2 * radius * (foot + U * (3 * l1Norm + radius));
    }

    /**
     * Bounds the error of the same number computed as (direction . (origin - centre))^2 less the origin's power: less
     * than {@link #sphereSquare} where a ray starts close to a huge sphere and nearly along it.
     *
     * @param alongError  of direction . (origin - centre)
     * @param powerError  of the origin's power, which also rounds by u
     */
    public static double tangentSquare(double along, double alongError, double power, double powerError) {
        return alongError * (2 * Math.abs(along) + alongError) + powerError + 2 * U * (along * along + Math.abs(power));
    }

    /**
     * Bounds the error of the distance at which a ray hits a sphere. Half the chord and the distance to its middle
     * round by what their terms do; a distance that is the power over their sum only in proportion. Where the ray is
     * off by some length, it hits the sphere off by that over the cosine, which is half the chord over the radius.
     *
     * @param half  half the chord, the root of r^2 - p^2
     * @param along direction . (origin - centre)
     */
    public static double sphereDistance(double originError, double directionError, double l1Norm, double radius,
            double half, double along, double distance) {
        double sum = half + Math.abs(along);
        double rounding = (root(sphereSquare(0, 0, l1Norm, radius, along), half) + 3 * U * (l1Norm + sum))
                * Math.min(1, distance / sum);
        double ray = originError + DIAGONAL * directionError * distance;
        return rounding + root(2 * radius * ray, half) + U * distance;
    }

    /** Bounds the error of the distance from where a ray has arrived to a light, but for the origin's own. */
    public static double lightDistance(double positionError, double distance) {
        return positionError + 4 * U * distance;
    }

    /** Bounds the error of a root of a square that is off by so much. */
    private static double root(double square, double root) {
        return Math.min(square / (2 * root), Math.sqrt(square));
    }

    /**
     * The part of a distance's own rounding that stays where a ray hits a sphere nearer than its chord's middle, as the
     * distance is the power over half the chord and the distance to its middle, then.
     *
     * @param half  half the chord
     * @param along direction . (origin - centre)
     */
    public static double spherePart(double half, double along, double distance) {
        return Math.min(1, distance / (half + Math.abs(along)));
    }

    /**
     * Bounds by how much a ray from the eye is off beside its way where it hits a sphere: what the perpendicular rounds by,
     * and the direction's error.
     *
     * @param part as {@link #spherePart} has it
     */
    public static double sphereSink(double l1Norm, double radius, double part, double distance) {
        return U * (3 * l1Norm + radius) * part + DIAGONAL * EYE_DIRECTION * distance;
    }

    /**
     * Bounds how far off along its ray a point is where that has hit a sphere: {@link #sphereDistance} of a ray from the
     * eye, as far as it is granted. Beside the ray by {@code sink}, it is hit off by that over the cosine, half / radius.
     */
    public static double sphereSlide(double l1Norm, double radius, double half, double part, double distance, double sink) {
        return Math.min(MAX_SLIDE * distance,
                U * ((6 * l1Norm + 3 * radius) * part + distance) + sink * radius / half);
    }
}
