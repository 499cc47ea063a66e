package raytracer.render;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * How many samples the pixels of a picture get, so that the root of the mean square of all pixels' errors is as wanted
 * in the least time: all pixels the same number, or those that are not settled as many as they take. It is found from
 * the variances v within some of the pixels.
 *
 * <p>The mean of N even samples of a pixel that an edge crosses is off by about C v^1/2 N^-3/4 (Mitchell,
 * Consequences of Stratified Sampling in Graphics, 1996). The fewest samples for a given sum of such errors' squares
 * are those with N in proportion to v^0.4 (Lagrange).
 *
 * @param initial so many samples of an unsettled pixel decide how many it gets
 * @param unseen the variance that so many samples do not see, on average
 * @param k      an unsettled pixel of variance v gets k (v + unseen)^0.4 samples, if that is more
 * @param all    so many samples of every pixel take less time than proofs and those; 0 if they do not
 */
record SampleBudget(int initial, double unseen, double k, int all) {

    /** The most samples of a pixel. */
    static final int MAX = 4096;

    /**
     * By how much C may be greater for pixels that get samples by what few of them show: measured, so that no scene of
     * thin things misses its aim.
     */
    private static final double CAUTION = 1.25;

    /**
     * Of so many samples, lattices are off at edges by as much as others of .8 times as many: measured on random ones,
     * where C is .80 to .88 for these, and .69 to .83 for all others.
     */
    private static final Set<Integer> UNEVEN = Set.of(3, 6, 9, 10, 11, 15);
    private static final double UNEVEN_PART = 0.8;

    /**
     * n samples miss a part a of a pixel with a chance of (1 - a)^n at most. The error that this leaves is greatest for
     * a = 2 / (n + 2), and meets the aim if n is in proportion to the root of variance by aim.
     */
    private static final double INITIAL = 2;

    /**
     * What no sample of a pixel has seen is missing whole, while even samples average out most of what they see: its error
     * is so many times as much, measured on needles and slats.
     */
    private static final double MISSED = 10;

    /**
     * What choosing pixels costs: proofs take as long as so many samples of every pixel (measured on 17 scenes: 1 to 9); a
     * sample of a chosen pixel takes so many times as long as one among all its neighbours (1.4 to 4).
     */
    private static final double PROOF = 6;
    private static final double SCATTER = 2.2;

    private static final int MIN_INITIAL = 4;
    private static final int MAX_INITIAL = 100;

    /** A step of 256, squared: a variance below it shows nothing. */
    private static final double INVISIBLE = 1 / (255.0 * 255);

    /** Enough that k is as good as exact. */
    private static final int BISECTIONS = 40;

    /**
     * A pixel.
     *
     * @param coarse   the variance within it, by {@link Pilots#COARSE} samples
     * @param variance the same by {@link Pilots#FINE}
     * @param change   the square of how far the two means are apart
     */
    record Pilot(double coarse, double variance, double change) { }

    /**
     * @param pilots    some of the picture's pixels
     * @param unsettled which part of its pixels is unsettled; 0 if that is not known yet: then as few samples are given
     *                  to chosen pixels as it can be
     * @param wanted    the root of the mean square of the errors
     */
    static SampleBudget plan(List<Pilot> pilots, double unsettled, double wanted) {
        double square = wanted * wanted * pilots.size() / (1 + 2 * standardError(pilots));
        double sum = pilots.stream().mapToDouble(Pilot::variance).sum();
        // C^2 times the sum: both means are off.
        double c2Sum = pilots.stream().mapToDouble(Pilot::change).sum()
                / (Math.pow(Pilots.COARSE, -1.5) + Math.pow(Pilots.FINE, -1.5));
        double all = forAll(pilots, sum, c2Sum, square);
        int same = latticeAsGoodAs(all);
        int initial = (int) Math.max(MIN_INITIAL, Math.min(MAX_INITIAL, Math.ceil(INITIAL * Math.pow(all, 0.75))));
        double[] variances = unsettled(pilots, unsettled);
        double unseen = unsettled == 0 ? 0 : unseen(pilots, variances.length, initial);
        SampleBudget chosen = choose(variances, initial, unseen, square * sum / (CAUTION * CAUTION * c2Sum));
        double samples = AdaptiveSampler.FIRST_SAMPLES
                + Arrays.stream(variances).map(chosen::samples).sum() / pilots.size();
        return PROOF + SCATTER * samples < same ? chosen : new SampleBudget(initial, unseen, chosen.k, same);
    }

    /** How many samples of every pixel leave no more than this sum of the squares of errors. */
    private static double forAll(List<Pilot> pilots, double sum, double c2Sum, double square) {
        // One sample leaves all of the variance: it is not one of several that are even.
        int min = sum > square ? 2 : 1;
        // Of a thing that is smaller than samples are apart, they are off as if they were at random: by v / N.
        double small = pilots.stream().filter(pilot -> pilot.coarse < INVISIBLE).mapToDouble(Pilot::variance).sum();
        return Math.max(min, Math.max(Math.pow(c2Sum / square, 2 / 3.0), Math.min(Pilots.FINE, small / square)));
    }

    /** Of the sum of all changes, as a part of it. */
    private static double standardError(List<Pilot> pilots) {
        double sum = pilots.stream().mapToDouble(Pilot::change).sum();
        double squares = pilots.stream().mapToDouble(pilot -> pilot.change * pilot.change).sum();
        return sum > 0 ? Math.sqrt(squares) / sum : 0;
    }

    /** The least number of samples whose lattice is as good as one of so many. */
    private static int latticeAsGoodAs(double number) {
        return IntStream.range(1, MAX).filter(n -> (UNEVEN.contains(n) ? UNEVEN_PART : 1) * n >= number).findFirst()
                .orElse(MAX);
    }

    /** The variances of the pilots that are unsettled: those that show any, and 0 for the others. */
    private static double[] unsettled(List<Pilot> pilots, double part) {
        double[] visible = pilots.stream().mapToDouble(Pilot::variance).filter(v -> v >= INVISIBLE).toArray();
        return Arrays.copyOf(visible, Math.max(visible.length, (int) (part * pilots.size())));
    }

    /** What few samples of an unsettled pixel do not see, as more samples of pilots tell. */
    private static double unseen(List<Pilot> pilots, int unsettled, int initial) {
        long seen = pilots.stream().filter(pilot -> Math.min(pilot.coarse, pilot.variance) >= INVISIBLE).count();
        double sum = pilots.stream().filter(pilot -> pilot.coarse < INVISIBLE && pilot.variance >= INVISIBLE)
                .mapToDouble(Pilot::variance).sum();
        return sum == 0 ? 0 : MISSED * sum / (unsettled - seen) * Pilots.COARSE / initial;
    }

    /** @param square the greatest sum of v N^-1.5 */
    private static SampleBudget choose(double[] variances, int initial, double unseen, double square) {
        double[] weights = Arrays.stream(variances).map(v -> weight(v + unseen)).toArray();
        double low = 0, high = MAX / weight(INVISIBLE);
        for (int i = 0; i < BISECTIONS; i++) {
            double k = (low + high) / 2;
            SampleBudget budget = new SampleBudget(initial, unseen, k, 0);
            if (budget.squares(weights) > square) {
                low = k;
            } else {
                high = k;
            }
        }
        return new SampleBudget(initial, unseen, high, 0);
    }

    /** The sum of v N^-1.5. */
    private double squares(double[] weights) {
        double sum = 0;
        for (double w : weights) {
            double r = w / samplesOf(w);
            sum += w * r * Math.sqrt(r);
        }
        return sum;
    }

    private static double weight(double variance) {
        return Math.pow(variance, 0.4);
    }

    /** Of an unsettled pixel of this variance. */
    int samples(double variance) {
        return samplesOf(weight(variance + unseen));
    }

    private int samplesOf(double weight) {
        return (int) Math.max(initial, Math.min(MAX, Math.round(k * weight)));
    }
}
