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

    /** Bounds the error of each coordinate of a ray from the eye: scaled basis, products, sums and normalising. */
    static final double EYE_DIRECTION = 5 * U;

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
     * Bounds the error of direction . normal, of unit vectors: 4u from the normal, products and sums, and the
     * direction's own. A ray whose cosine is not above it counts as parallel to the plane: not even the sign is known.
     *
     * @param directionError of each coordinate of the direction
     */
    static double cosine(double directionError) {
        return DIAGONAL * directionError + 4 * U;
    }

    /**
     * Bounds the error of the distance at which a ray meets a plane: that of the offset, and the distance times that of
     * the cosine, both divided by the cosine.
     */
    static double planeDistance(
            double originError, double directionError, double reach, double distance, double cosine) {
        return (planeOffset(originError, reach) + distance * cosine(directionError)) / Math.abs(cosine);
    }

    /**
     * Bounds the error in each coordinate of a computed point of a plane or triangle, origin + distance * direction, as
     * against the point where the same ray meets it exactly: the distance's error, and 2u of the distance and u of the
     * point from direction, product and sum. That the ray itself may be off is left out: that moves the point along the
     * plane, and counted in, errors would seem to multiply from mirror to mirror.
     *
     * @param position |x| + |y| + |z| of the computed point
     */
    static double planePosition(double reach, double distance, double cosine, double position) {
        return planeDistance(0, EYE_DIRECTION, reach, distance, cosine) + U * (3 * distance + position);
    }

    /**
     * Bounds the error of direction . (edge x (a + b)), a and b being the edge's ends seen from the origin: the ends
     * round by u and the sum by 2u of their distance, products and sums by 6u of theirs times the edge, all of it twice
     * at most; where the ray is off by some length, the result is by that times twice the edge.
     *
     * @param reach |x| + |y| + |z| of the farther end
     * @param edge  |x| + |y| + |z| of the edge, or more
     */
    static double edge(double originError, double directionError, double reach, double edge) {
        return edge * (24 * U * reach + 2 * DIAGONAL * (originError + directionError * reach));
    }

    /** Bounds the error of the power of an origin, |origin - centre|^2 - r^2, due to the origin's error. */
    static double power(double originError, double radius) {
        return 2 * DIAGONAL * radius * originError;
    }

    /**
     * Bounds the error of the power of a point as it is computed without {@link PowerOfPoint}: 2u from differences, u
     * from squares and 3u from sums.
     *
     * @param square |point - centre|^2
     */
    static double plainPower(double square, double radius) {
        return 8 * U * (square + radius * radius);
    }

    /**
     * Bounds the error of the power of a ray's origin as it is computed from (direction . (origin - centre))^2 and
     * r^2 - p^2, p being the perpendicular from the centre to the ray: 22u of |origin - centre|^2 from the first, 40u
     * from the second and 4u from the direction's length; p^2 is at most 5/4 r^2.
     */
    static double passingPower(double alongSquare, double radiusSquare) {
        return 96 * U * (alongSquare + radiusSquare);
    }

    /**
     * Bounds the error of direction . (origin - centre): 3u of the offset, and the errors of both.
     *
     * @param reach |x| + |y| + |z| of origin - centre
     */
    static double along(double originError, double directionError, double reach) {
        return (3 * U + directionError) * reach + DIAGONAL * originError;
    }

    /**
     * Bounds the error of r^2 - p^2, p being the perpendicular from the centre to the ray: each of its coordinates
     * rounds by 3u of the offset and is off as the ray is at its foot, so the difference is off by 2r times that and
     * 2u r^2. (As far as r and p are alike: where they are not, the sign is beyond doubt.)
     */
    static double sphereSquare(double originError, double directionError, double reach, double radius, double along) {
        double foot = DIAGONAL * (originError + directionError * Math.abs(along));
        return 2 * radius * (foot + U * (3 * reach + radius));
    }

    /**
     * Bounds the error of the distance at which a ray meets a sphere. Half the chord and the distance to its middle
     * round by what their terms do; a distance that is the power over their sum only in proportion. Where the ray is
     * off by some length, it meets the sphere off by that over the cosine, which is half the chord over the radius.
     *
     * @param half  half the chord, the root of r^2 - p^2
     * @param along direction . (origin - centre)
     */
    static double sphereDistance(double originError, double directionError, double reach, double radius, double half,
            double along, double distance) {
        double sum = half + Math.abs(along);
        double rounding = (root(sphereSquare(0, 0, reach, radius, along), half) + 3 * U * (reach + sum))
                * Math.min(1, distance / sum);
        double ray = DIAGONAL * (originError + directionError * distance);
        return rounding + root(2 * radius * ray, half) + U * distance;
    }

    /** Bounds the error of a root of a square that is off by so much. */
    private static double root(double square, double root) {
        return Math.min(square / (2 * root), Math.sqrt(square));
    }

    /**
     * Bounds the error in each coordinate of computed points of spheres, centre + radius * normal, as against the
     * points where the same rays meet them exactly: the {@linkplain #sphereDistance distance}'s error, 2u of the
     * distance from the direction, and 7u of the radius and u of the centre from the normal and the sum.
     *
     * @param centre |x| + |y| + |z| of the centre
     * @param reach  of origin - centre; is overwritten, as is part
     */
    static Pass spherePosition(double[] centre, double[] reach, double[] radius, double[] along, double[] distance,
            double[] part, double[] out) {
        return new Pass.InTurn(
                new PartOfRounding(along, distance, out, part),
                new OfDistance(reach, distance, part, out),
                new OfPoint(centre, radius, out),
                new Squares(reach, radius, distance, part),
                new AddRoots(reach, along, distance, out));
    }

    /** The part of rounding errors that a distance has which is the power over a sum. */
    private record PartOfRounding(double[] along, double[] distance, double[] sum, double[] part) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                sum[i] = Math.abs(distance[i] + along[i]) + Math.abs(along[i]);
                part[i] = Math.min(1, distance[i] / sum[i]);
            }
        }
    }

    /** The distance's linear part and its share of the direction's, in place of the sum: in units of 3u. */
    private record OfDistance(double[] reach, double[] distance, double[] part, double[] sum) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                sum[i] = (reach[i] + sum[i]) * part[i] + distance[i];
            }
        }
    }

    /** All that is linear. */
    private record OfPoint(double[] centre, double[] radius, double[] out) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = U * (3 * out[i] + 7 * radius[i] + centre[i]);
            }
        }
    }

    /** The errors under the root, in place of the reach. */
    private record Squares(double[] reach, double[] radius, double[] distance, double[] part) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                reach[i] = 2 * radius[i]
                        * (U * (3 * reach[i] + radius[i]) * part[i] + DIAGONAL * EYE_DIRECTION * distance[i]);
            }
        }
    }

    /** Two errors are under the root together; apart, their roots add up to the root of 2 times that at most. */
    private record AddRoots(double[] square, double[] along, double[] distance, double[] out) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                double half = Math.abs(distance[i] + along[i]);
                out[i] += Math.min(square[i] / (2 * half), Math.sqrt(2 * square[i]));
            }
        }
    }
}
