package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

@DisplayName("A budget of samples")
class SampleBudgetTest {

    private static double[] filled(int count, double value) {
        double[] values = new double[count];
        Arrays.fill(values, value);
        return values;
    }

    @Test
    void isAGridWhereAllPixelsAreAsUneven() {
        // Error^2 = v / N^3 for all: N = (.1 / .01^2)^(1/3) = 10.
        assertEquals(10, SampleBudget.plan(filled(1000, .1 - 1e-9), 1000, .01, 1.27).grid());
    }

    @Test
    void spendsNothingOnAPictureWithoutEdges() {
        SampleBudget budget = SampleBudget.plan(new double[0], 1000, .0039, 1.27);
        assertTrue(budget.grid() <= 1, budget.toString());
    }

    @Test
    void givesAFewUnevenPixelsTheSamplesThatTheErrorAllows() {
        // One pixel in 20: v / (20 N^3) = error^2 makes N = (.1 / (20 .004^2))^(1/3) = 6.8.
        SampleBudget budget = SampleBudget.plan(filled(50, .1), 1000, .004, 1.27);
        assertEquals(0, budget.grid());
        assertEquals(7, budget.along(.1), budget.toString());
        assertEquals(budget.closer(), budget.along(0));
    }

    @Test
    void growsWithTheVarianceToThePowerOfOneFifth() {
        double[] variances = filled(100, .1);
        Arrays.fill(variances, 0, 50, .1 / 32);
        SampleBudget budget = SampleBudget.plan(variances, 2000, .001, 1.27);
        // Rounding to whole numbers leaves half a sample on either side.
        assertEquals(budget.along(.1), 2 * budget.along(.1 / 32), 1.5, budget.toString());
    }

    @Test
    void neverGivesMoreThanTheMost() {
        assertTrue(SampleBudget.plan(filled(10, 1), 1000, 1e-4, 5).along(1) <= SampleBudget.MAX);
    }
}
