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

    /** C of the edges' errors, squared, if 4 samples are off by as much as a grid of them at an edge. */
    private static final double C2 = 0.7 * 0.7;

    private static final double CAUTION2 = 1.3 * 1.3;

    /** Many pixels of a variance, each a block of its own, so that little is left to chance. */
    private static List<List<SampleBudget.Pilot>> pilots(int count, double variance) {
        return pilots(count, variance, variance);
    }

    private static List<List<SampleBudget.Pilot>> pilots(int count, double coarse, double variance) {
        return Collections.nCopies(count,
                List.of(new SampleBudget.Pilot(coarse, variance, C2 * variance * Math.pow(4, -1.5))));
    }

    private static double samples(double variance, double square) {
        return Math.pow(CAUTION2 * C2 * variance / square, 2 / 3.0);
    }

    @Test
    void isTheSameForAllWhereAllPixelsAreAsUneven() {
        // Error^2 = C^2 v / N^1.5 for all; twice the standard error of 10,000 blocks adds 2 %.
        assertEquals(samples(.1, 1e-4 / 1.02), SampleBudget.plan(pilots(10_000, .1), 10_000, .01, 1.1).all(), 1);
    }

    @Test
    void isNothingForAPictureWithoutEdges() {
        SampleBudget budget = SampleBudget.plan(List.of(), 1000, .0039, 1.1);
        assertTrue(budget.all() <= 1, budget.toString());
    }

    @Test
    void isOneSampleOnlyIfItMayBeOffByAllOfTheVariance() {
        // C says that even one sample of .1 is off by .29 at most; but what one shows is off by .32.
        assertEquals(2, SampleBudget.plan(pilots(10_000, .1), 10_000, .3, 1.1).all());
        assertEquals(1, SampleBudget.plan(pilots(10_000, .1), 10_000, .33, 1.1).all());
    }

    @Test
    void givesAFewUnevenPixelsTheSamplesThatTheErrorAllows() {
        // One pixel in 50: C^2 v / (50 N^1.5) = error^2.
        SampleBudget budget = SampleBudget.plan(pilots(2500, .1), 125_000, .0015, 1.1);
        assertEquals(0, budget.all());
        assertEquals(samples(.1 / 50, 2.25e-6 / 1.04), budget.samples(.1), 1, budget.toString());
        assertEquals(budget.initial(), budget.samples(0));
    }

    @Test
    void growsWithTheVarianceToThePowerOfTwoFifths() {
        List<List<SampleBudget.Pilot>> pilots = new ArrayList<>(pilots(50, .1));
        pilots.addAll(pilots(50, .1 / 32));
        SampleBudget budget = SampleBudget.plan(pilots, 5000, .0001, 1.1);
        assertEquals(budget.samples(.1), 4 * budget.samples(.1 / 32), 4, budget.toString());
    }

    @Test
    void isMoreWhereFewSamplesOverlookMuch() {
        List<List<SampleBudget.Pilot>> seen = pilots(50, .1), overlooked = pilots(50, 0, .1);
        SampleBudget a = SampleBudget.plan(seen, 1000, .01, 1.1), b = SampleBudget.plan(overlooked, 1000, .01, 1.1);
        assertEquals(0, a.unseen());
        assertTrue(b.samples(0) > a.samples(0), a + " " + b);
    }

    @Test
    void isMoreWhereLittleIsKnown() {
        SampleBudget many = SampleBudget.plan(pilots(2500, .1), 125_000, .0015, 1.1);
        SampleBudget few = SampleBudget.plan(pilots(4, .1), 200, .0015, 1.1);
        assertTrue(few.samples(.1) > 1.2 * many.samples(.1), few + " " + many);
    }

    @Test
    void isMoreWhereFewSamplesAreOffByMore() {
        List<List<SampleBudget.Pilot>> even = pilots(1000, .1), uneven = Collections.nCopies(1000,
                List.of(new SampleBudget.Pilot(.1, .1, .1 / 4)));
        assertTrue(SampleBudget.plan(uneven, 1000, .01, 1.1).all() > 2 * SampleBudget.plan(even, 1000, .01, 1.1).all());
    }

    @Test
    void neverGivesMoreThanTheMost() {
        assertTrue(SampleBudget.plan(pilots(10, 1), 1000, 1e-4, 5).samples(1) <= SampleBudget.MAX);
    }
}
