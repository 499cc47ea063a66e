package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Arrays;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.tracer.arithmetic.Rounding;

/** Colours computed by hand. The pixel looks from (0, 0, 5) at the origin. */
class ShadingTest {

    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 16 * Rounding.U;

    private static final String WALL = "plane 0 0 0 0 0 1\n";

    private static void assertMiddle(double red, double green, double blue, String text) throws Exception {
        assertArrayEquals(new double[] {red, green, blue}, Pictures.middle(text), ROUNDING);
    }

    @Test
    void isBlackWhereNothingIsHit() throws Exception {
        assertMiddle(0, 0, 0, "ambient 1 1 1\nsphere 3 0 0 1\n");
    }

    @Test
    void isAmbientWithoutLights() throws Exception {
        assertMiddle(.1, .2, 3, "ambient .1 .2 3\ndiffuse 1 1 1\nspecular 1 1 1\n" + WALL);
    }

    @Test
    void isLambertForALightAtSixtyDegrees() throws Exception {
        String light = "directional 0 " + Math.sqrt(3) + " 1  .5 1 2\n";
        assertMiddle(.2 * .5 / 2, .4 * 1 / 2.0, .6 * 2 / 2, light + "diffuse .2 .4 .6\n" + WALL);
    }

    @Test
    void isAmbientWhereTheLightItselfIsThoughOthersAroundAreLit() throws Exception {
        double[] colours = Pictures.trace("size 3 3\ncamera 0 0 5 0 0 0 0 1 0 45\npoint 0 0 0 1 1 1\n"
                + "ambient .25 .25 .25\nspecular .5 .5 .5\nshininess 2\n" + WALL);
        int middle = 3 * 4;
        assertEquals(.25, colours[middle]);
        assertTrue(colours[middle - 3] > .3 && colours[middle + 3] > .3, () -> Arrays.toString(colours));
    }

    @Test
    void isUnattenuatedByDistance() throws Exception {
        assertMiddle(.5, .5, .5, "point 0 0 1000 1 1 1\ndiffuse .5 .5 .5\n" + WALL);
    }

    @Test
    void hasNoLambertFromBehindAndNormalsAreNotTurned() throws Exception {
        assertMiddle(0, 0, 0, "directional 0 0 -1 1 1 1\ndiffuse 1 1 1\n" + WALL);
        assertMiddle(0, 0, 0, "point 0 0 3 1 1 1\ndiffuse 1 1 1\nplane 0 0 0 0 0 -1\n");
        assertMiddle(.5, .5, .5, "directional 0 0 -1 1 1 1\ndiffuse .5 .5 .5\nplane 0 0 0 0 0 -1\n");
    }

    @Test
    void isBlinnPhongWithTheHalfVector() throws Exception {
        // Light at 60 degrees, view at 0: the half vector at 30 degrees, cosine sqrt(3)/2, to the 4th 9/16.
        String light = "directional 0 " + Math.sqrt(3) + " 1  1 .5 0\n";
        assertMiddle(.8 * 9 / 16, .8 * .5 * 9 / 16, 0, light + "specular .8 .8 .8\nshininess 4\n" + WALL);
    }

    @Test
    void isHighlightedByALightSoBrightThatNoDoubleHoldsThePower() throws Exception {
        // n.h is cos 60 degrees: 2^-1080, below the least double, times 1e308.
        String light = "directional 0 " + Math.sqrt(3) + " -1  1e308 1e308 0\n";
        double seen = Pictures.middle(light + "specular 1 1 1\nshininess 1080\n" + WALL)[0];
        assertEquals(1, seen / (1e308 * 0x1p-1000 * 0x1p-80), 1e-10);
    }

    @Test
    void isHighlightedEvenWhereTheLightIsBehindTheSurface() throws Exception {
        // 120 degrees from the normal: no Lambert, and n.h is cos 60 degrees.
        String light = "directional 0 " + Math.sqrt(3) + " -1  1 1 1\n";
        assertMiddle(.25, .25, .25, light + "diffuse 1 1 1\nspecular 1 1 1\nshininess 2\n" + WALL);
    }

    @Test
    void addsUpLightsAndIsNotCut() throws Exception {
        assertMiddle(3, 2, 0, "diffuse 1 1 0\n" + WALL + "point 0 0 3 1 2 5\npoint 0 0 9 2 0 5\n");
    }

    @Test
    void isAmbientInShadow() throws Exception {
        assertMiddle(.1, .1, .1, "ambient .1 .1 .1\ndiffuse 1 1 1\npoint 0 8 8 1 1 1\n" + WALL + "sphere 0 4 4 1\n");
    }

    @Test
    void isAmbientOnASphereInsideAnotherThatHasTheLightOutside() throws Exception {
        double[] colours = Pictures.trace("size 16 16\ncamera 0 0 0 0 0 -1 0 1 0 90\nambient .1 .1 .1\ndiffuse 1 1 1\n"
                + "point 0 20 0 1 1 1\nsphere 0 0 0 10\nsphere 0 0 -5 2\n");
        int seen = 0;
        for (int pixel = 0; pixel < 256; pixel++) {
            // The inner one is seen within 3.49 pixels of the middle, next to the outer one.
            if (Math.hypot(pixel % 16 - 7.5, pixel / 16 - 7.5) < 3.4) {
                assertEquals(.1, colours[3 * pixel], "pixel " + pixel);
                seen++;
            }
        }
        assertEquals(32, seen);
    }

    @Test
    void gainsNothingFromALightExactlyThere() throws Exception {
        assertMiddle(.25, .25, .25,
                "ambient .25 .25 .25\ndiffuse 1 1 1\nspecular 1 1 1\nshininess 0\npoint 0 0 0 1 1 1\n" + WALL);
    }

    @Test
    void countsZeroToTheZeroAsOne() throws Exception {
        // The light is straight behind the wall: the half vector is 0, and so is n.h.
        assertMiddle(.5, .5, .5, "directional 0 0 -1 1 1 1\nspecular .5 .5 .5\nshininess 0\n" + WALL);
    }

    @Test
    void isSaturatedByAnInfiniteHighlightOnlyWhereThereIsSpecularLight() throws Exception {
        double[] c = Pictures.middle(
                "directional 0 0 -1 1 1 0\nambient .1 .1 .1\nspecular .5 0 .5\nshininess -1\nmaxdepth 3\n" + WALL);
        assertEquals(Double.POSITIVE_INFINITY, c[0]);
        assertEquals(.1, c[1]);
        assertEquals(.1, c[2]);
    }

    @Test
    void addsMirrorsUpToTheDepth() throws Exception {
        // The eye between a mirror with colour .1 and a wall with colour .4 behind it.
        String text = "ambient .1 .1 .1\nspecular .5 .25 0\n" + WALL
                + "ambient .4 .4 .4\nspecular 0 0 0\nplane 0 0 9 0 0 -1\n";
        assertMiddle(.1, .1, .1, text);
        assertMiddle(.1 + .5 * .4, .1 + .25 * .4, .1, "maxdepth 2\n" + text);
        assertMiddle(.1 + .5 * .4, .1 + .25 * .4, .1, "maxdepth 9\n" + text);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 10, 100, 1000})
    void betweenTwoMirrorsIsAGeometricSeries(int depth) throws Exception {
        String text = "maxdepth " + depth + "\nambient .01 .01 .01\nspecular .9 .5 0\n" + WALL
                + "plane 0 0 9 0 0 -1\n";
        assertMiddle(.01 * (1 - Math.pow(.9, depth)) / (1 - .9), .01 * (1 - Math.pow(.5, depth)) / (1 - .5), .01, text);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 5, 60})
    void inAFurnaceIsTheSameEverywhere(int depth) throws Exception {
        double[] colours = Pictures.trace("size 9 9\ncamera .1 .2 .3 0 0 0 0 1 0 100\nmaxdepth " + depth
                + "\nambient .01 .01 .01\nspecular .8 .8 .8\nsphere 0 0 0 3\n");
        double[] expected = new double[colours.length];
        Arrays.fill(expected, .01 * (1 - Math.pow(.8, depth)) / (1 - .8));
        assertArrayEquals(expected, colours, 64 * ROUNDING);
    }

    @Test
    void atAnyDepthNeedsNoStackAndStopsWhenNothingCanChange() {
        Assertions.assertTimeoutPreemptively(Duration.ofSeconds(30), () -> {
            double[] dark = Pictures.middle("maxdepth 1000000\nambient 1e-7 1e-7 1e-7\nspecular 1 1 1\n" + WALL
                    + "plane 0 0 9 0 0 -1\n");
            assertEquals(.1, dark[0], 1e-9);
            double[] saturated = Pictures.middle("maxdepth 2000000000\nambient .1 .1 .1\nspecular 1 1 1\n" + WALL
                    + "plane 0 0 9 0 0 -1\n");
            assertTrue(saturated[0] >= 1 && saturated[0] < 1.2);
            double[] fading = Pictures.middle("maxdepth 2000000000\nambient .1 .1 .1\nspecular .5 .5 .5\n" + WALL
                    + "plane 0 0 9 0 0 -1\n");
            assertEquals(.2, fading[0], ROUNDING);
        });
    }
}
