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

    /** C of the edges' errors, squared. */
    private static final double C2 = 1.25 * 1.25;

    private static List<SampleBudget.Pilot> pilots(int count, double variance) {
        return Collections.nCopies(count, new SampleBudget.Pilot(variance, variance));
    }

    @Test
    void isTheSameForAllWhereAllPixelsAreAsUneven() {
        // Error^2 = C^2 v / N^1.5 for all: N = (C^2 .1 / .01^2)^(2/3).
        assertEquals(Math.ceil(Math.pow(C2 * .1 / 1e-4, 2 / 3.0)), SampleBudget.plan(pilots(1000, .1), 1000, .01, 1.1).all());
    }

    @Test
    void isNothingForAPictureWithoutEdges() {
        SampleBudget budget = SampleBudget.plan(List.of(), 1000, .0039, 1.1);
        assertTrue(budget.all() <= 1, budget.toString());
    }

    @Test
    void givesAFewUnevenPixelsTheSamplesThatTheErrorAllows() {
        // One pixel in 20: C^2 v / (20 N^1.5) = error^2.
        SampleBudget budget = SampleBudget.plan(pilots(50, .1), 1000, .004, 1.1);
        assertEquals(0, budget.all());
        assertEquals(Math.pow(C2 * .1 / 20 / 16e-6, 2 / 3.0), budget.samples(.1), 1, budget.toString());
        assertEquals(budget.closer(), budget.samples(0));
    }

    @Test
    void growsWithTheVarianceToThePowerOfTwoFifths() {
        List<SampleBudget.Pilot> pilots = new ArrayList<>(pilots(50, .1));
        pilots.addAll(pilots(50, .1 / 32));
        SampleBudget budget = SampleBudget.plan(pilots, 2000, .0003, 1.1);
        assertEquals(budget.samples(.1), 4 * budget.samples(.1 / 32), 4, budget.toString());
    }

    @Test
    void isMoreWhereAGlanceOverlooksMuch() {
        List<SampleBudget.Pilot> seen = pilots(50, .1), overlooked = Collections.nCopies(50, new SampleBudget.Pilot(0, .1));
        SampleBudget a = SampleBudget.plan(seen, 1000, .01, 1.1), b = SampleBudget.plan(overlooked, 1000, .01, 1.1);
        assertEquals(0, a.unseen());
        assertTrue(b.samples(0) > a.samples(0), a + " " + b);
    }

    @Test
    void neverGivesMoreThanTheMost() {
        assertTrue(SampleBudget.plan(pilots(10, 1), 1000, 1e-4, 5).samples(1) <= SampleBudget.MAX);
    }
}
