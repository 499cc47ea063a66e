package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.parser.Scenes;
import raytracer.tracer.rays.Samples;

@DisplayName("A pixel is settled")
class SettledCellsTest {

    private static final int SIDE = 19;
    private static final double TOLERANCE = 1 / 255.0;

    /** In the plane z = 0, which this shows, a pixel is 1 wide: x and y are the picture's columns and rows upwards. */
    private static final String VIEW = String.format(Locale.ROOT,
            "size %d %d\ncamera %s %s %s  %s %s 0  0 1 0  90\n", SIDE, SIDE, SIDE / 2.0, SIDE / 2.0, SIDE / 2.0,
            SIDE / 2.0, SIDE / 2.0);

    private static boolean[] settled(String text) throws Exception {
        return Tracer.compile(Scenes.parse(VIEW + text).scene()).newTileTracer()
                .traceCorners(0, 0, SIDE, SIDE, TOLERANCE, new Samples());
    }

    private static int count(boolean[] settled) {
        int count = 0;
        for (boolean one : settled) {
            count += one ? 1 : 0;
        }
        return count;
    }

    private static String needle(double x0, double y0, double x1, double y1, double z, double width) {
        double length = Math.hypot(x1 - x0, y1 - y0), px = -(y1 - y0) / length * width, py = (x1 - x0) / length * width;
        return String.format(Locale.ROOT, "maxverts 3\nvertex %s %s %s\nvertex %s %s %s\nvertex %s %s %s\ntri 0 1 2\n",
                x0, y0, z, x1, y1, z, x1 + px, y1 + py, z);
    }

    private static void assertUnsettledAlong(boolean[] settled, double x0, double y0, double x1, double y1) {
        for (double t = 0; t <= 1; t += 1e-3) {
            int column = (int) (x0 + t * (x1 - x0)), row = SIDE - 1 - (int) (y0 + t * (y1 - y0));
            assertFalse(settled[row * SIDE + column], "pixel " + column + "," + row);
        }
    }

    @ParameterizedTest(name = "nowhere along a needle of a thousandth of its width, between all samples (seed {0})")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void nowhereAlongANeedle(long seed) throws Exception {
        Random random = new Random(seed);
        double x0 = .01 + random.nextDouble() * 18, y0 = .01 + random.nextDouble() * 18;
        double x1 = .01 + random.nextDouble() * 18, y1 = .01 + random.nextDouble() * 18;
        String needle = needle(x0, y0, x1, y1, 0, .001);
        assertUnsettledAlong(settled("ambient 1 1 1\n" + needle), x0, y0, x1, y1);
        boolean[] onAPlane = settled("ambient .5 .5 .5\nplane 0 0 -1 0 0 1\nambient 1 0 0\n" + needle);
        assertUnsettledAlong(onAPlane, x0, y0, x1, y1);
        assertTrue(count(onAPlane) > SIDE * SIDE - 120, count(onAPlane) + " are settled");
    }

    @Test
    @DisplayName("nowhere along the shadow of a needle")
    void nowhereAlongAShadow() throws Exception {
        // The light is behind the eye; the needle is behind it too, and only its shadow is seen.
        String text = "directional 0 0 1 1 1 1\ndiffuse .8 .8 .8\nplane 0 0 0 0 0 1\n" + needle(2.3, 3.1, 15.2, 14.7, 12, .001);
        boolean[] settled = settled(text);
        assertUnsettledAlong(settled, 2.3, 3.1, 15.2, 14.7);
        assertTrue(count(settled) > SIDE * SIDE / 2, count(settled) + " are settled");
    }

    @Test
    @DisplayName("nowhere along the image of a needle in a mirror")
    void nowhereAlongAMirrorsImage() throws Exception {
        // As far behind the eye as the eye is from the mirror: the image is at three times the eye's distance.
        String text = "maxdepth 2\nspecular 1 1 1\nplane 0 0 0 0 0 1\nspecular 0 0 0\nambient 1 1 1\n"
                + needle(-10, -3.3, 27, 21.9, 19, .001);
        boolean[] settled = settled(text);
        double middle = SIDE / 2.0;
        assertUnsettledAlong(settled, middle + (-10 - middle) / 3, middle + (-3.3 - middle) / 3, middle + (27 - middle) / 3,
                middle + (21.9 - middle) / 3);
        assertTrue(count(settled) > SIDE * SIDE / 2, count(settled) + " are settled");
    }

    @Test
    @DisplayName("not where a gap between two triangles of one colour is between its corners")
    void notOverAGap() throws Exception {
        assertTrue(count(settled("ambient 1 1 1\nmaxverts 8\nvertex -9 -9 0\nvertex 9.4 -9 0\nvertex 9.4 99 0\n"
                + "vertex 9.6 -9 0\nvertex 99 -9 0\nvertex 9.6 99 0\ntri 0 1 2\ntri 3 4 5\n")) <= SIDE * SIDE - SIDE);
    }

    @Test
    @DisplayName("not where a highlight is narrower than it")
    void notUnderANarrowHighlight() throws Exception {
        String text = "point 9.3 9.7 30 1 1 1\nspecular 1 1 1\nplane 0 0 0 0 0 1\n";
        boolean[] narrow = settled("shininess 1e7\n" + text);
        assertFalse(narrow[9 * SIDE + 9]);
        assertTrue(count(narrow) > SIDE * SIDE - 10, count(narrow) + " are settled");
    }
}
