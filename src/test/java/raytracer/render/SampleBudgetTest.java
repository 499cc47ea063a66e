package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A budget of samples. */
class SampleBudgetTest {

    /** C of the edges' errors, squared, if few samples are off by as much as a grid of them at an edge. */
    private static final double C2 = 0.7 * 0.7;

    private static final double CAUTION2 = 1.1 * 1.1;

    /** By how much the means of 4 and of 16 samples differ, squared. */
    private static final double CHANGE = Math.pow(4, -1.5) + Math.pow(16, -1.5);

    /** Many pixels of a variance, so that little is left to chance. */
    private static List<SampleBudget.Pilot> pilots(int count, double variance) {
        return pilots(count, variance, variance);
    }

    private static List<SampleBudget.Pilot> pilots(int count, double coarse, double variance) {
        return Collections.nCopies(count, new SampleBudget.Pilot(coarse, variance, C2 * variance * CHANGE));
    }

    /** Pixels of which one in so many is uneven. */
    private static List<SampleBudget.Pilot> oneIn(int part, int count, double variance) {
        List<SampleBudget.Pilot> pilots = new ArrayList<>(pilots(count, variance));
        pilots.addAll(pilots((part - 1) * count, 0));
        return pilots;
    }

    private static int plan(List<SampleBudget.Pilot> pilots, double wanted) {
        return SampleBudget.plan(pilots, 4, wanted);
    }

    private static double samples(double c2, double variance, double square) {
        return Math.pow(c2 * variance / square, 2 / 3.0);
    }

    @Test
    void fallsWithTheSquareOfTheErrorToThePowerOfTwoThirds() {
        // Error^2 = C^2 v / N^1.5 for all; twice the standard error of 10,000 pilots adds 2 %.
        assertEquals(samples(CAUTION2 * C2, .1, 1e-4 / 1.02), plan(pilots(10_000, .1), .01), 1);
    }

    @Test
    void isOneSampleForAPictureWithoutEdges() {
        assertEquals(1, plan(pilots(14_000, 0), .0039));
    }

    @Test
    void isOneSampleOnlyIfItMayBeOffByAllOfTheVariance() {
        // C says that even one sample of .1 is off by .29 at most; but what one shows is off by .32.
        assertEquals(2, plan(pilots(10_000, .1), .3));
        assertEquals(1, plan(pilots(10_000, .1), .33));
    }

    @Test
    void isInProportionToTheVarianceWhereFewSamplesAreOffAsRandomOnesAre() {
        // Error^2 = v / N, but for the caution, and as means of 4 and 16 differ by 1/4 + 1/16, not by 1/8 + 1/64.
        List<SampleBudget.Pilot> hairs = Collections.nCopies(10_000,
                new SampleBudget.Pilot(.1, .1, .1 * (1 / 4.0 + 1 / 16.0)));
        assertEquals(CAUTION2 * .1 / 1e-4 * 1.02 * 1.25 / 1.125, plan(hairs, .01), 2);
    }

    @Test
    void isNotOneSampleForAFewPilotsThatShowNothing() {
        // Of 3 rare samples expected among the 16 of each of 2,000 pilots, none is seen in one of 20 pictures.
        assertEquals(Math.ceil(3 / 16.0 / 2000 / 1.5e-5), plan(pilots(2000, 0), Math.sqrt(1.5e-5)));
        assertEquals(1, plan(pilots(20_000, 0), Math.sqrt(1.5e-5)));
    }

    @Test
    void takesTheErrorsOfThingsThatFewSamplesOverlookForThoseOfPointsAtRandom() {
        // One of 16 samples in each of 200 pixels: all four others are off by 1/16 alone, which says less than v / N.
        List<SampleBudget.Pilot> pilots = new ArrayList<>(
                Collections.nCopies(200, new SampleBudget.Pilot(0, 15 / 256.0, 1 / 256.0)));
        pilots.addAll(pilots(9800, 0));
        assertEquals(15 / 256.0 / 50 / (1.7e-4 / 1.14), plan(pilots, Math.sqrt(1.7e-4)), 1);
    }

    @Test
    void isMoreWhereLittleIsKnown() {
        int many = plan(oneIn(50, 2500, .1), .0015), few = plan(oneIn(50, 4, .1), .0015);
        assertTrue(few > 1.2 * many, few + " " + many);
    }

    @Test
    void isMoreWhereFewSamplesAreOffByMore() {
        List<SampleBudget.Pilot> even = pilots(1000, .1), uneven = Collections.nCopies(1000,
                new SampleBudget.Pilot(.1, .1, .1 / 4));
        assertTrue(plan(uneven, .01) > 2 * plan(even, .01));
    }

    @Test
    void neverGivesMoreThanTheMost() {
        assertEquals(SampleBudget.MAX, plan(pilots(10, 1), 1e-4));
    }
}
