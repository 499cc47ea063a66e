package raytracer.render;

import java.util.List;

/**
 * How many samples all pixels of a picture get, so that the root of the mean square of their errors is as wanted. It is
 * found from the variances v within some of the pixels, and from how far few samples are off there.
 *
 * <p>The square of the error of N even samples' mean falls with N^p. Where edges cross pixels, p is 1.5 (Mitchell,
 * Consequences of Stratified Sampling in Graphics, 1996); where things are thinner than samples are apart, it is 1, as
 * of random samples, whose square is v / N.
 */
final class SampleBudget {

    /** The most samples of a pixel. */
    static final int MAX = 4096;

    /** Of N, for even samples at edges. */
    private static final double MAX_POWER = 1.5;

    /**
     * By how much errors may be greater than the pilots say: measured, so that scenes of thin things keep to their aims.
     */
    private static final double CAUTION = 1.1;

    /** Where so many samples of pilots are expected to hit small things, there is a chance of 1 in 20 that none does. */
    private static final double UNSEEN = 3;

    /** A step of 256, squared: a variance below it shows nothing. */
    private static final double INVISIBLE = 1 / (255.0 * 255);

    private SampleBudget() { }

    /**
     * A pixel.
     *
     * @param coarse   the variance within it, by few samples
     * @param variance the same by four times as many
     * @param change   the square of how far the two means are apart
     */
    record Pilot(double coarse, double variance, double change) { }

    /**
     * How many samples every pixel gets.
     *
     * @param pilots some of the picture's pixels
     * @param few    how many samples their coarse variances are of
     * @param wanted the root of the mean square of the errors
     */
    static int plan(List<Pilot> pilots, int few, double wanted) {
        double square = wanted * wanted * pilots.size() / (1 + 2 * standardError(pilots));
        double variances = pilots.stream().mapToDouble(Pilot::variance).sum();
        // What few samples leave, of which the change tells: both means are off.
        double ofFew = CAUTION * CAUTION * pilots.stream().mapToDouble(Pilot::change).sum()
                / (1 + Math.pow(4, -MAX_POWER));
        double power = variances > ofFew
                ? Math.max(1, Math.min(MAX_POWER, Math.log(variances / ofFew) / Math.log(few))) : 1;
        // One sample leaves all of the variance; up to few, errors become less as a power of their number.
        double even = square < ofFew || variances <= ofFew ? few * Math.pow(ofFew / square, 1 / power)
                : Math.pow(few, Math.log(square / variances) / Math.log(ofFew / variances));
        // Of a thing that is smaller than samples are apart, they are off as if they were at random: by v / N.
        double small = pilots.stream().filter(pilot -> pilot.coarse < INVISIBLE).mapToDouble(Pilot::variance).sum();
        double random = Math.max(Math.min(4 * few, small / square), UNSEEN / (4 * few) / square);
        return (int) Math.max(1, Math.min(MAX, Math.ceil(Math.max(even, random))));
    }

    /** Of the sum of all changes, as a part of it. */
    private static double standardError(List<Pilot> pilots) {
        double sum = pilots.stream().mapToDouble(Pilot::change).sum();
        double squares = pilots.stream().mapToDouble(pilot -> pilot.change * pilot.change).sum();
        return sum > 0 ? Math.sqrt(squares) / sum : 0;
    }
}
