package raytracer.render;

import java.util.Arrays;
import java.util.List;

/**
 * How many samples the pixels of a picture get, so that the root of the mean square of all pixels' errors is as wanted
 * in the least time: all pixels the same number, or those that are not settled as many as they take. It is found from
 * the variances v within some of the pixels.
 *
 * <p>The square of the error of N even samples' mean falls with N^p. Where edges cross pixels, p is 1.5 (Mitchell,
 * Consequences of Stratified Sampling in Graphics, 1996); where things are thinner than samples are apart, it is 1, as
 * of random samples, whose square is v / N. Which it is shows in how far few samples are off.
 *
 * @param chosen what pixels get that are not settled
 * @param all    so many samples of every pixel take less time than proofs and those; 0 if they do not
 * @param cost   so many samples of every pixel take as long
 */
record SampleBudget(Chosen chosen, int all, double cost) {

    /** The most samples of a pixel. */
    static final int MAX = 4096;

    /** Of N, for even samples at edges. */
    private static final double MAX_POWER = 1.5;

    /**
     * By how much errors may be greater than the pilots say, and how many times that where pixels get samples by what few
     * of them show: measured, so that scenes of thin things keep to their aims.
     */
    private static final double CAUTION = 1.05;
    private static final double CHOICE_CAUTION = 1.3;

    /**
     * n samples miss a part a of a pixel with a chance of (1 - a)^n at most. The error that this leaves is greatest for
     * a = 2 / (n + 2), and meets the aim if n is in proportion to the root of variance by aim.
     */
    private static final double INITIAL = 2;

    /**
     * What no sample of a pixel has seen is missing whole, while even samples average out most of what they see: its
     * error is so many times as much, measured on needles and slats.
     */
    private static final double MISSED = 10;

    /**
     * What choosing pixels costs: proofs take as long as so many samples of every pixel (measured on 17 scenes: 1 to
     * 9); a sample of a chosen pixel takes so many times as long as one among all its neighbours (1.4 to 4).
     */
    private static final double PROOF = 6;
    private static final double SCATTER = 2.2;

    /** Where so many samples of pilots are expected to hit small things, there is a chance of 1 in 20 that none does. */
    private static final double UNSEEN = 3;

    private static final int MIN_INITIAL = 4;
    private static final int MAX_INITIAL = 100;

    /** A step of 256, squared: a variance below it shows nothing. */
    private static final double INVISIBLE = 1 / (255.0 * 255);

    /** Enough that k is as good as exact. */
    private static final int BISECTIONS = 30;

    /**
     * A pixel.
     *
     * @param coarse   the variance within it, by few samples
     * @param variance the same by four times as many
     * @param change   the square of how far the two means are apart
     */
    record Pilot(double coarse, double variance, double change) { }

    /**
     * How many samples unsettled pixels get.
     *
     * @param initial so many samples of a pixel decide how many it gets
     * @param unseen  the variance that so many samples do not see, on average
     * @param power   p
     * @param k       a pixel of variance v gets k (v + unseen)^(1 / (1 + p)) samples, if that is more: for the fewest in
     *                all (Lagrange)
     */
    record Chosen(int initial, double unseen, double power, double k) {

        int samples(double variance) {
            return (int) Math.max(initial, Math.min(MAX, Math.round(k * weight(variance))));
        }

        private double weight(double variance) {
            return Math.pow(variance + unseen, 1 / (1 + power));
        }

        /** The sum of v / N^power. */
        private double squares(double[] variances) {
            return Arrays.stream(variances).map(v -> (v + unseen) * Math.pow(samples(v), -power)).sum();
        }
    }

    /**
     * @param pilots    some of the picture's pixels
     * @param few       how many samples their coarse variances are of
     * @param unsettled which part of its pixels is unsettled; 0 if that is not known yet: then as few samples are given
     *                  to chosen pixels as it can be
     * @param wanted    the root of the mean square of the errors
     */
    static SampleBudget plan(List<Pilot> pilots, int few, double unsettled, double wanted) {
        double square = wanted * wanted * pilots.size() / (1 + 2 * standardError(pilots));
        double variances = pilots.stream().mapToDouble(Pilot::variance).sum();
        // Both means are off.
        double ofFew = CAUTION * CAUTION * pilots.stream().mapToDouble(Pilot::change).sum()
                / (1 + Math.pow(4, -MAX_POWER));
        double power = variances > ofFew
                ? Math.max(1, Math.min(MAX_POWER, Math.log(variances / ofFew) / Math.log(few))) : 1;
        double all = forAll(pilots, few, ofFew, power, square);
        int same = (int) Math.min(MAX, Math.ceil(all));
        int initial = (int) Math.max(MIN_INITIAL, Math.min(MAX_INITIAL, Math.ceil(INITIAL * Math.pow(all, 0.75))));
        double[] unsettledVariances = unsettled(pilots, unsettled);
        double unseen = unsettled == 0 ? 0 : unseen(pilots, few, unsettledVariances.length, initial);
        Chosen chosen = choose(unsettledVariances, initial, unseen, power,
                square * variances / (CHOICE_CAUTION * CHOICE_CAUTION * ofFew * Math.pow(few, power)));
        double samples = AdaptiveSampler.FIRST_SAMPLES
                + Arrays.stream(unsettledVariances).map(chosen::samples).sum() / pilots.size();
        double cost = PROOF + SCATTER * samples;
        return new SampleBudget(chosen, cost < same ? 0 : same, Math.min(cost, same));
    }

    /**
     * How many samples of every pixel leave no more than this sum of the squares of errors.
     *
     * @param ofFew the sum that few samples leave
     */
    private static double forAll(List<Pilot> pilots, int few, double ofFew, double power, double square) {
        double variances = pilots.stream().mapToDouble(Pilot::variance).sum();
        // One sample leaves all of the variance; up to few, errors become less as a power of their number.
        double even = square < ofFew || variances <= ofFew ? few * Math.pow(ofFew / square, 1 / power)
                : Math.pow(few, Math.log(square / variances) / Math.log(ofFew / variances));
        // Of a thing that is smaller than samples are apart, they are off as if they were at random: by v / N.
        double small = pilots.stream().filter(pilot -> pilot.coarse < INVISIBLE).mapToDouble(Pilot::variance).sum();
        double random = Math.max(Math.min(4 * few, small / square), UNSEEN / (4 * few) / square);
        return Math.max(1, Math.max(even, random));
    }

    /** Of the sum of all changes, as a part of it. */
    private static double standardError(List<Pilot> pilots) {
        double sum = pilots.stream().mapToDouble(Pilot::change).sum();
        double squares = pilots.stream().mapToDouble(pilot -> pilot.change * pilot.change).sum();
        return sum > 0 ? Math.sqrt(squares) / sum : 0;
    }

    /** The variances of the pilots that are unsettled: those that show any, and 0 for the others. */
    private static double[] unsettled(List<Pilot> pilots, double part) {
        double[] visible = pilots.stream().mapToDouble(Pilot::variance).filter(v -> v >= INVISIBLE).toArray();
        return Arrays.copyOf(visible, Math.max(visible.length, (int) (part * pilots.size())));
    }

    /** What few samples of an unsettled pixel do not see, as more samples of pilots tell. */
    private static double unseen(List<Pilot> pilots, int few, int unsettled, int initial) {
        long seen = pilots.stream().filter(pilot -> Math.min(pilot.coarse, pilot.variance) >= INVISIBLE).count();
        double sum = pilots.stream().filter(pilot -> pilot.coarse < INVISIBLE && pilot.variance >= INVISIBLE)
                .mapToDouble(Pilot::variance).sum();
        return sum == 0 ? 0 : MISSED * sum / (unsettled - seen) * few / initial;
    }

    /** @param square the greatest sum of v / N^power */
    private static Chosen choose(double[] variances, int initial, double unseen, double power, double square) {
        double low = 0, high = MAX / Math.pow(INVISIBLE, 0.5);
        for (int i = 0; i < BISECTIONS; i++) {
            double k = (low + high) / 2;
            if (new Chosen(initial, unseen, power, k).squares(variances) > square) {
                low = k;
            } else {
                high = k;
            }
        }
        return new Chosen(initial, unseen, power, high);
    }
}
