package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

@DisplayName("A budget of samples")
class SampleBudgetTest {

    /** C of the edges' errors, squared, if few samples are off by as much as a grid of them at an edge. */
    private static final double C2 = 0.7 * 0.7;

    private static final double CAUTION2 = 1.05 * 1.05;
    private static final double CHOICE_CAUTION2 = CAUTION2 * 1.3 * 1.3;

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

    private static SampleBudget plan(List<SampleBudget.Pilot> pilots, double unsettled, double wanted) {
        return SampleBudget.plan(pilots, 4, unsettled, wanted);
    }

    private static double samples(double c2, double variance, double square) {
        return Math.pow(c2 * variance / square, 2 / 3.0);
    }

    @Test
    void isTheSameForAllWhereAllPixelsAreAsUneven() {
        // Error^2 = C^2 v / N^1.5 for all; twice the standard error of 10,000 pilots adds 2 %.
        SampleBudget budget = plan(pilots(10_000, .1), 1, .01);
        assertEquals(samples(CAUTION2 * C2, .1, 1e-4 / 1.02), budget.all(), 1);
    }

    @Test
    void isOneSampleForAPictureWithoutEdges() {
        assertEquals(1, plan(pilots(14_000, 0), 0, .0039).all());
    }

    @Test
    void isOneSampleOnlyIfItMayBeOffByAllOfTheVariance() {
        // C says that even one sample of .1 is off by .29 at most; but what one shows is off by .32.
        assertEquals(2, plan(pilots(10_000, .1), 0, .3).all());
        assertEquals(1, plan(pilots(10_000, .1), 0, .33).all());
    }

    @Test
    void isInProportionToTheVarianceWhereFewSamplesAreOffAsRandomOnesAre() {
        // Error^2 = v / N, but for the caution, and as means of 4 and 16 differ by 1/4 + 1/16, not by 1/8 + 1/64.
        List<SampleBudget.Pilot> hairs = Collections.nCopies(10_000,
                new SampleBudget.Pilot(.1, .1, .1 * (1 / 4.0 + 1 / 16.0)));
        assertEquals(CAUTION2 * .1 / 1e-4 * 1.02 * 1.25 / 1.125, plan(hairs, 1, .01).all(), 2);
    }

    @Test
    void isNotOneSampleForAFewPilotsThatShowNothing() {
        // Of 3 rare samples expected among the 16 of each of 2,000 pilots, none is seen in one of 20 pictures.
        assertEquals(Math.ceil(3 / 16.0 / 2000 / 1.5e-5), plan(pilots(2000, 0), 0, Math.sqrt(1.5e-5)).all());
        assertEquals(1, plan(pilots(20_000, 0), 0, Math.sqrt(1.5e-5)).all());
    }

    @Test
    void givesAFewUnevenPixelsTheSamplesThatTheErrorAllows() {
        // One pixel in 50: C^2 v / (50 N^1.5) = error^2; twice the standard error of 2,500 adds 4 %.
        SampleBudget budget = plan(oneIn(50, 2500, .1), .02, .0015);
        assertEquals(0, budget.all());
        assertEquals(samples(CHOICE_CAUTION2 * C2, .1 / 50, 2.25e-6 / 1.04), budget.chosen().samples(.1), 1, budget.toString());
        assertEquals(budget.chosen().initial(), budget.chosen().samples(0));
    }

    @Test
    void isTheSameForAllWhereManyMayBeUnsettledThatShowNoVariance() {
        assertEquals(0, plan(oneIn(50, 2500, .1), .3, .0015).all());
        assertTrue(plan(oneIn(50, 2500, .1), 1, .0015).all() > 0);
    }

    @Test
    void growsWithTheVarianceToThePowerOfTwoFifths() {
        List<SampleBudget.Pilot> pilots = new ArrayList<>(oneIn(50, 50, .1));
        pilots.addAll(pilots(50, .1 / 32));
        SampleBudget budget = plan(pilots, 0, .0003);
        assertEquals(budget.chosen().samples(.1), 4 * budget.chosen().samples(.1 / 32), 4, budget.toString());
    }

    @Test
    void isMoreWhereFewSamplesOverlookMuch() {
        List<SampleBudget.Pilot> seen = oneIn(20, 50, .1), overlooked = new ArrayList<>(pilots(50, 0, .1));
        overlooked.addAll(pilots(950, 0));
        SampleBudget a = plan(seen, .1, .01), b = plan(overlooked, .1, .01);
        assertEquals(0, a.chosen().unseen());
        assertTrue(b.chosen().samples(0) > a.chosen().samples(0), a + " " + b);
    }

    @Test
    void takesTheErrorsOfThingsThatFewSamplesOverlookForThoseOfPointsAtRandom() {
        // One of 16 samples in each of 200 pixels: all four others are off by 1/16 alone, which says less than v / N.
        List<SampleBudget.Pilot> pilots = new ArrayList<>(
                Collections.nCopies(200, new SampleBudget.Pilot(0, 15 / 256.0, 1 / 256.0)));
        pilots.addAll(pilots(9800, 0));
        assertEquals(15 / 256.0 / 50 / (1.7e-4 / 1.14), plan(pilots, 1, Math.sqrt(1.7e-4)).all(), 1);
    }

    @Test
    void isMoreWhereLittleIsKnown() {
        SampleBudget many = plan(oneIn(50, 2500, .1), 0, .0015);
        SampleBudget few = plan(oneIn(50, 4, .1), 0, .0015);
        assertTrue(few.chosen().samples(.1) > 1.2 * many.chosen().samples(.1), few + " " + many);
    }

    @Test
    void isMoreWhereFewSamplesAreOffByMore() {
        List<SampleBudget.Pilot> even = pilots(1000, .1), uneven = Collections.nCopies(1000,
                new SampleBudget.Pilot(.1, .1, .1 / 4));
        assertTrue(plan(uneven, 1, .01).all() > 2 * plan(even, 1, .01).all());
    }

    @Test
    void neverGivesMoreThanTheMost() {
        assertTrue(plan(pilots(10, 1), 1, 1e-4).chosen().samples(1) <= SampleBudget.MAX);
    }
}
