package raytracer.render;

import java.util.List;

/**
 * How many samples the pixels of a picture get that are not settled, so that the root of the mean square of all pixels'
 * errors is as wanted with the fewest samples in all. It is found from the variances v within some of the pixels.
 *
 * <p>The mean of N even samples of a pixel that an edge crosses is off by about C v^1/2 N^-3/4 (Mitchell,
 * Consequences of Stratified Sampling in Graphics, 1996). The fewest samples for a given sum of such errors' squares
 * are those with N in proportion to v^0.4 (Lagrange).
 *
 * @param closer samples of an unsettled pixel that decide how many it gets
 * @param unseen the variance that so many samples do not see, on average
 * @param k      an unsettled pixel of variance v gets k (v + unseen)^0.4 samples, if that is more
 * @param all    so many samples of every pixel are fewer in all; 0 if not
 */
record SampleBudget(int closer, double unseen, double k, int all) {

    /** The most samples of a pixel. */
    static final int MAX = 4096;

    /** C: measured, so that none of the scenes of thin things misses its aim. */
    private static final double EDGE_ERROR = 1.25;

    /**
     * A part a of a pixel that differs is missed by n samples with a chance of (1 - a)^n at most; the error that this
     * leaves is greatest for a = 2 / (n + 2), and is the aim for an n in proportion to the root of variance by aim.
     */
    private static final double CLOSER = 1.5;

    /**
     * What no sample of a pixel has seen is off by all that it adds, and not by what even samples leave of it: so many
     * times as much, measured on needles and slats.
     */
    private static final double MISSED = 10;

    private static final int MIN_CLOSER = 4;
    private static final int MAX_CLOSER = 100;

    /** A step of 256, squared: a variance below it shows nothing. */
    private static final double INVISIBLE = 1 / (255.0 * 255);

    /** Enough that k is as good as exact. */
    private static final int BISECTIONS = 40;

    /** The variance within an unsettled pixel, by as few samples as {@link AdaptiveSampler#GLANCE}, and by more. */
    record Pilot(double atAGlance, double variance) { }

    /**
     * @param pilots of the unsettled among some of the picture's pixels
     * @param pixels how many pixels those are in all, with the settled ones
     * @param error  the root of the mean square that is wanted
     * @param first  samples of each pixel before it is known which are settled
     */
    static SampleBudget plan(List<Pilot> pilots, long pixels, double error, double first) {
        double overlooked = pilots.stream().filter(pilot -> pilot.atAGlance < INVISIBLE)
                .mapToDouble(Pilot::variance).average().orElse(0);
        double sum = pilots.stream().mapToDouble(Pilot::variance).sum();
        double even = Math.pow(EDGE_ERROR * EDGE_ERROR / (error * error) * sum / pixels, 2 / 3.0);
        int closer = (int) Math.max(MIN_CLOSER, Math.min(MAX_CLOSER, Math.ceil(CLOSER * Math.pow(even, 0.75))));
        double unseen = MISSED * overlooked * AdaptiveSampler.GLANCE / closer;
        double low = 0, high = MAX / Math.pow(INVISIBLE, 0.4);
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = (low + high) / 2;
            if (new SampleBudget(closer, unseen, middle, 0).squares(pilots) > error * error * pixels) {
                low = middle;
            } else {
                high = middle;
            }
        }
        SampleBudget budget = new SampleBudget(closer, unseen, high, 0);
        int all = (int) Math.max(1, Math.min(MAX, Math.ceil(even)));
        double samples = first + pilots.stream().mapToDouble(pilot -> budget.samples(pilot.variance)).sum() / pixels;
        return samples < all ? budget : new SampleBudget(closer, unseen, high, all);
    }

    /** Of an unsettled pixel of this variance. */
    int samples(double variance) {
        return (int) Math.max(closer, Math.min(MAX, Math.round(k * Math.pow(variance + unseen, 0.4))));
    }

    /** The sum of the squares of the pilots' errors. */
    private double squares(List<Pilot> pilots) {
        return pilots.stream().mapToDouble(pilot -> EDGE_ERROR * EDGE_ERROR * (pilot.variance + unseen)
                * Math.pow(samples(pilot.variance), -1.5)).sum();
    }
}
