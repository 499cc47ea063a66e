package raytracer.tracer;

/**
 * Bounds on the rounding errors of the tracer's arithmetic. They take the place of epsilons: each grows with the
 * numbers that entered a computation, so a scene scaled by a power of two is decided in the same way, bit for bit.
 * First-order analysis after Higham, Accuracy and Stability of Numerical Algorithms (2002), chapter 3, and pbrt-v4,
 * section 6.8; u is the unit roundoff and second-order terms are covered by rounding the factors up.
 */
final class Rounding {

    /** The unit roundoff of double: half the distance from 1 to the next. */
    static final double U = 0x1p-53;

    /** The square root of 3, rounded up: how far a point can be when each coordinate is off by at most 1. */
    private static final double DIAGONAL = 1.7320508075688774;

    /**
     * Relative to the distance: how much farther than the nearest hit so far a hit may be and still be compared with
     * it as a possible tie. Only a first sieve; {@link #planeDistance} and {@link #sphereDistance} decide. It is far
     * above the error of any hit that is not grazing by less than a millionth of a radian.
     */
    static final double TIE_SIEVE = 0x1p-20;

    private Rounding() { }

    /**
     * Bounds the error of (point - origin) . normal, a unit normal.
     *
     * <p>Subtraction, products and sums round by 4u of the sum of the coordinates' magnitudes; an origin that is off
     * by e in each coordinate adds e times the square root of 3.
     *
     * @param originError of each coordinate of the origin
     * @param reach       |x| + |y| + |z| of point - origin
     */
    static double planeOffset(double originError, double reach) {
        return DIAGONAL * originError + 4 * U * reach;
    }

    /**
     * Bounds the error of the distance at which a ray meets a plane: that of the offset and that of direction . normal
     * (3u), both divided by |direction . normal|.
     */
    static double planeDistance(double originError, double reach, double distance, double cosine) {
        return (planeOffset(originError, reach) + 4 * U * distance) / Math.abs(cosine);
    }

    /**
     * Bounds the error in each coordinate of a computed point of a plane or triangle, origin + distance * direction, as
     * against the point where the same ray meets it exactly: the distance's error, and 2u of the distance and u of the
     * point from direction, product and sum. That the origin may be off too is left out: it moves the point along the
     * plane, and counted in, errors would seem to multiply from mirror to mirror.
     *
     * @param position |x| + |y| + |z| of the computed point
     */
    static double planePosition(double reach, double distance, double cosine, double position) {
        return planeDistance(0, reach, distance, cosine) + U * (3 * distance + position);
    }

    /** Bounds the error of the power of an origin, |origin - centre|^2 - r^2, due to the origin's error. */
    static double power(double originError, double radius) {
        return 2 * DIAGONAL * radius * originError;
    }

    /**
     * Bounds the error of the distance at which a ray meets a sphere, from that of the perpendicular p from the centre
     * to the ray: each of its coordinates rounds by 3u of the offset, so r^2 - p^2 is off by 2r times that and 2u r^2,
     * and its root by the same over twice the root. The sums that follow round by 3u of their terms.
     *
     * @param reach |x| + |y| + |z| of origin - centre
     * @param half  half the chord, the root of r^2 - p^2
     * @param along direction . (origin - centre)
     */
    static double sphereDistance(double originError, double reach, double radius, double half, double along) {
        double perpendicular = 3 * U * reach + DIAGONAL * originError;
        double square = 2 * radius * (perpendicular + U * radius);
        double root = half * half > square ? square / (2 * half) : Math.sqrt(square);
        return root + DIAGONAL * originError + 3 * U * (Math.abs(along) + half);
    }

    /**
     * Bounds the error in each coordinate of a computed point of a sphere, centre + radius * normal, as against the
     * point where the same ray meets it exactly: the distance's error, 2u of the distance from the direction, and 6u of
     * the radius and u of the centre from the normal and the sum.
     *
     * @param centre |x| + |y| + |z| of the centre
     */
    static double spherePosition(double centre, double reach, double radius, double half, double along) {
        return sphereDistance(0, reach, radius, half, along) + U * (2 * (Math.abs(along) + half) + 6 * radius + centre);
    }
}
