package raytracer.render;

import java.util.Arrays;

/**
 * How many samples the pixels of a picture get, so that the root of the mean square of their errors is as wanted with
 * the fewest samples in all. It is found from the variances v within some of the picture's pixels.
 *
 * <p>The error of the mean of N x N samples in a grid is about C v^1/2 N^-3/2 where an edge crosses the pixel
 * (Mitchell, Consequences of Stratified Sampling in Graphics, 1996). The fewest samples for a given sum of such
 * errors' squares are those with N in proportion to v^0.2 (Lagrange).
 *
 * @param closer samples along an unsettled pixel's side that decide how many it gets
 * @param k      an unsettled pixel of variance v gets k v^0.2 along its side, if that is more
 * @param grid   so many along every pixel's side are fewer in all; 0 if not
 */
record SampleBudget(int closer, double k, int grid) {

    /** The most samples along a pixel's side. */
    static final int MAX = 32;

    /** C: fitted to four scenes of edges, shadows, mirrors and thin things, so that none misses its aim by a fifth. */
    private static final double EDGE_ERROR = 1;

    /**
     * A closer look of n x n samples does not see what is in a corner smaller than its own part of the pixel; the
     * errors of that fall like n^-5/2, faster than those that are seen.
     */
    private static final double CLOSER_EXPONENT = 0.75;

    private static final int MIN_CLOSER = 2;
    private static final int MAX_CLOSER = 6;

    /** Enough that k is as good as exact. */
    private static final int BISECTIONS = 40;

    /**
     * @param variances of the unsettled among some of the picture's pixels
     * @param pixels    how many pixels those are in all, with the settled ones
     * @param error     the root of the mean square that is wanted
     * @param first     samples of each pixel in the pass that tells which are settled
     */
    static SampleBudget plan(double[] variances, long pixels, double error, double first) {
        double even = Math.cbrt(square(EDGE_ERROR / error) * Arrays.stream(variances).sum() / pixels);
        int closer = (int) Math.max(MIN_CLOSER, Math.min(MAX_CLOSER, Math.ceil(Math.pow(even, CLOSER_EXPONENT))));
        double low = 0, high = MAX / Math.pow(square(1 / 255.0), 0.2);
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = (low + high) / 2;
            if (meanSquare(variances, pixels, closer, middle) > square(error)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        int grid = (int) Math.max(1, Math.min(MAX, Math.ceil(even)));
        double samples = first + cost(variances, closer, high) / pixels;
        return new SampleBudget(closer, high, samples < square(grid) ? 0 : grid);
    }

    /** Samples along the side of an unsettled pixel of this variance. */
    int along(double variance) {
        return along(variance, closer, k);
    }

    private static int along(double variance, int closer, double k) {
        return (int) Math.max(closer, Math.min(MAX, Math.round(k * Math.pow(variance, 0.2))));
    }

    private static double meanSquare(double[] variances, long pixels, int closer, double k) {
        double sum = 0;
        for (double v : variances) {
            double n = along(v, closer, k);
            sum += square(EDGE_ERROR) * v / (n * n * n);
        }
        return sum / pixels;
    }

    private static double cost(double[] variances, int closer, double k) {
        double samples = 0;
        for (double v : variances) {
            int n = along(v, closer, k);
            samples += square(closer) + (n > closer ? square(n) : 0);
        }
        return samples;
    }

    private static double square(double v) {
        return v * v;
    }
}
