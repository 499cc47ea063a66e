package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Vector;
import raytracer.tracer.Pictures;

/** Mirrors hold where recursion and drift fail. */
class MirrorStabilityTest {

    private static final String CORRIDOR = "size 3 3\ncamera .1 .2 .3 1 .3 .35 0 1 0 40\nmaxdepth %d\n"
            + "ambient 1e-5 2e-5 3e-5\nspecular %s %s %s\nplane 1 0 0 -1 0 0\nplane -1 0 0 1 0 0\n";

    @ParameterizedTest(name = "a corridor of depth {0}, mirrors of {1}")
    @CsvSource({"10, .5", "1000, .99", "10000, .999", "10000, 1", "100000, .9999"})
    void corridor(int depth, double mirror) throws Exception {
        double[] colours = Pictures.trace(String.format(java.util.Locale.ROOT, CORRIDOR, depth, mirror, mirror, mirror));
        double sum = mirror == 1 ? depth : (1 - Math.pow(mirror, depth)) / (1 - mirror);
        for (int i = 0; i < colours.length; i++) {
            double expected = 1e-5 * (1 + i % 3) * sum;
            assertEquals(expected, colours[i], 1e-11 * expected + 1e-16 * depth);
        }
    }

    private static double recursive(int depth, double mirror) {
        // What one level of a recursive tracer keeps on the stack, and more, though far less than a real one.
        double[] point = {depth, depth + 1, depth + 2};
        return depth == 0 ? point[0] : 1e-5 + mirror * recursive(depth - 1, mirror) + 0 * (point[1] + point[2]);
    }

    @Test
    @DisplayName("a million levels overflow a recursion's stack, and not the tracer's loop")
    void depth() throws Exception {
        assertThrows(StackOverflowError.class, () -> recursive(1_000_000, .999999));
        double[] colours = Pictures.trace(String.format(java.util.Locale.ROOT, CORRIDOR, 1_000_000, .99999, .9999, .999));
        double expected = 1e-5 * (1 - Math.pow(.99999, 1_000_000)) / (1 - .99999);
        assertEquals(expected, colours[0], 1e-9 * expected);
    }

    @Test
    @DisplayName("reflected a million times without normalising, a direction's length drifts")
    void drift() {
        Vector d = new Vector(.3, .5, .8).unit(), n = new Vector(.6, .7, .1).unit(), m = new Vector(-.1, .9, .3).unit();
        for (int i = 0; i < 500_000; i++) {
            d = Naive.reflect(Naive.reflect(d, n), m);
        }
        double drifted = Math.abs(d.length() - 1);
        assertTrue(drifted > 1e-14, "drifted by " + drifted);
    }

    @ParameterizedTest(name = "a furnace: closed mirrors, offset {0}, depth {1}")
    @CsvSource({"0, 50", "1e3, 50", "1e6, 20"})
    void furnace(double offset, int depth) throws Exception {
        Families.Writer w = new Families.Writer(new java.util.Random(1), 1, offset);
        w.text("size 16 12\nmaxdepth " + depth + "\nmaxverts 100\nambient .01 .01 .01\nspecular .9 .9 .9");
        w.move("camera", new double[] {.1, .2, .3});
        w.add(new double[] {1, .4, .1}).end(" 0 1 0 70");
        w.box(0, -1, 0, 1, 2);
        double expected = .01 * (1 - Math.pow(.9, depth)) / (1 - .9);
        for (double colour : Pictures.trace(w.toString())) {
            assertEquals(expected, colour, 1e-13, "no ray leaves a closed box, whatever edge it meets");
        }
    }
}
