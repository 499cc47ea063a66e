package raytracer.render;

import java.util.Arrays;
import java.util.List;

/**
 * How many samples the pixels of a picture get that are not settled, so that the root of the mean square of all pixels'
 * errors is as wanted with the fewest samples in all. It is found from the variances v within some of the pixels.
 *
 * <p>The mean of N even samples of a pixel that an edge crosses is off by about C v^1/2 N^-3/4 (Mitchell,
 * Consequences of Stratified Sampling in Graphics, 1996). The fewest samples for a given sum of such errors' squares
 * are those with N in proportion to v^0.4 (Lagrange).
 *
 * @param initial so many samples of an unsettled pixel decide how many it gets
 * @param unseen the variance that so many samples do not see, on average
 * @param k      an unsettled pixel of variance v gets k (v + unseen)^0.4 samples, if that is more
 * @param all    so many samples of every pixel take less time than that; 0 if they do not
 */
record SampleBudget(int initial, double unseen, double k, int all) {

    /** The most samples of a pixel. */
    static final int MAX = 4096;

    /** By how much C may be greater than the pilots say: measured, so that no scene of thin things misses its aim. */
    private static final double CAUTION = 1.3;

    /**
     * n samples miss a part a of a pixel with a chance of (1 - a)^n at most. The error that this leaves is greatest for
     * a = 2 / (n + 2), and meets the aim if n is in proportion to the root of variance by aim.
     */
    private static final double INITIAL = 1.5;

    /**
     * What no sample of a pixel has seen is missing whole, while even samples average out most of what they see: its error
     * is so many times as much, measured on needles and slats.
     */
    private static final double MISSED = 10;

    /**
     * What choosing pixels costs: proofs take as long as so many samples of every pixel (measured on six scenes: 3 to
     * 19); a sample of a chosen pixel takes so many times as long as one among all its neighbours.
     */
    private static final double PROOF = 6;
    private static final double SCATTER = 1.8;

    private static final int MIN_INITIAL = 4;
    private static final int MAX_INITIAL = 100;

    /** A step of 256, squared: a variance below it shows nothing. */
    private static final double INVISIBLE = 1 / (255.0 * 255);

    /** Enough that k is as good as exact. */
    private static final int BISECTIONS = 40;

    /**
     * An unsettled pixel.
     *
     * @param coarse   the variance within it, by {@link AdaptiveSampler#COARSE} samples
     * @param variance the same by more samples
     * @param change   the square of how far the two means are apart
     */
    record Pilot(double coarse, double variance, double change) { }

    /**
     * @param blocks the unsettled pixels of some of the picture's blocks of pixels
     * @param pixels how many pixels those blocks have in all, with the settled ones
     * @param wanted the root of the mean square of the errors
     * @param first  samples of each pixel before it is known which are settled
     */
    static SampleBudget plan(List<List<Pilot>> blocks, long pixels, double wanted, double first) {
        List<Pilot> pilots = blocks.stream().flatMap(List::stream).toList();
        double error = wanted / Math.sqrt(1 + 2 * standardError(blocks));
        double overlooked = pilots.stream().filter(pilot -> pilot.coarse < INVISIBLE)
                .mapToDouble(Pilot::variance).average().orElse(0);
        double sum = pilots.stream().mapToDouble(Pilot::variance).sum();
        double change = pilots.stream().mapToDouble(Pilot::change).sum();
        // C^2: nearly all of the change is the coarse mean's error.
        double c2 = sum > 0 ? CAUTION * CAUTION * Math.pow(AdaptiveSampler.COARSE, 1.5) * change / sum : 1;
        double even = Math.pow(c2 / (error * error) * sum / pixels, 2 / 3.0);
        int initial = (int) Math.max(MIN_INITIAL, Math.min(MAX_INITIAL, Math.ceil(INITIAL * Math.pow(even, 0.75))));
        double unseen = MISSED * overlooked * AdaptiveSampler.COARSE / initial;
        double low = 0, high = MAX / Math.pow(INVISIBLE, 0.4);
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = (low + high) / 2;
            if (new SampleBudget(initial, unseen, middle, 0).squares(pilots, c2) > error * error * pixels) {
                low = middle;
            } else {
                high = middle;
            }
        }
        SampleBudget budget = new SampleBudget(initial, unseen, high, 0);
        // One sample leaves all of the variance: it is not one of several that are even.
        int all = (int) Math.max(sum > error * error * pixels ? 2 : 1, Math.min(MAX, Math.ceil(even)));
        double samples = first + pilots.stream().mapToDouble(pilot -> budget.samples(pilot.variance)).sum() / pixels;
        return PROOF + SCATTER * samples < all ? budget : new SampleBudget(initial, unseen, high, all);
    }

    /** Of the sum of all variances, as a part of it. */
    private static double standardError(List<List<Pilot>> blocks) {
        double[] sums = blocks.stream().mapToDouble(block -> block.stream().mapToDouble(Pilot::variance).sum()).toArray();
        double sum = Arrays.stream(sums).sum(), squares = Arrays.stream(sums).map(s -> s * s).sum();
        return sum > 0 ? Math.sqrt(squares) / sum : 0;
    }

    /** Of an unsettled pixel of this variance. */
    int samples(double variance) {
        return (int) Math.max(initial, Math.min(MAX, Math.round(k * Math.pow(variance + unseen, 0.4))));
    }

    /** The sum of the squares of the pilots' errors. */
    private double squares(List<Pilot> pilots, double c2) {
        return pilots.stream().mapToDouble(pilot -> c2 * (pilot.variance + unseen)
                * Math.pow(samples(pilot.variance), -1.5)).sum();
    }
}
