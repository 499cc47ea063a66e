package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A message tells what to do. */
class AdviceTest extends CommandLine {

    private static final String HEAD = "size 32 24\ncamera 0 0 5 0 0 0 0 1 0 45\n";

    AdviceTest() {
        super(HEAD + "ambient .5 .5 .5\nsphere 0 0 0 1\n");
    }

    @ParameterizedTest(name = "a picture is black: {1}")
    @CsvSource(delimiter = '|', value = {
        "sphere 0 0 0 1;sphere 1 0 0 1;diffuse 1 1 1;point 1 2 3 1 1 1"
                + "| nothing that is seen has a diffuse or ambient colour; colours hold for the shapes after them,"
                + " and those from line 3 to line 4 come before any",
        "diffuse 1 1 1;point 1 2 3 1 1 1;maxverts 3;vertex 0 0 0;vertex 0 1 0;vertex 1 0 0;tri 0 1 2"
                + "| the triangles that are seen show their backs, from where their corners go clockwise",
        "diffuse 1 1 1;point 1 2 -30 1 1 1;sphere 0 0 0 1| all lights are behind the surfaces that are seen, or blocked",
        "diffuse 1 1 1;point 1 2 60 1 1 1;sphere 0 0 0 50| all lights are behind the surfaces that are seen, or blocked",
        "diffuse 1 1 1;sphere 0 0 0 1| there is no light and no ambient colour",
        "diffuse 1 1 1;point 1 2 3 1 1 1;sphere 0 0 900 1;plane 0 0 600 0 0 3| the camera sees nothing",
        "diffuse 1 1 1;point 1 2 3 1 1 1;sphere 8 8 0 1| the camera sees nothing",
        "diffuse 1 0 0;point 1 2 3 0 0 1;sphere 0 0 0 1| what is seen returns no colour that a light has"})
    void black(String lines, String reason) throws IOException {
        assertEquals(0, run(file("b.scene", HEAD + lines.replace(';', '\n')), "-o", picture, "--quiet"));
        assertTrue(err().contains("warning: the picture is black: " + reason.trim()), err());
    }

    @ParameterizedTest(name = "a picture is nearly white: {1}")
    @CsvSource(delimiter = '|', value = {
        "ambient 255 128 0;sphere 0 0 0 9| a colour on line 3 goes up to 255.0, and they are meant to be from 0 to 1",
        "diffuse .9 .9 .9;sphere 0 0 0 4.9;directional 0 0 1 .6 .6 .6;directional 0 .1 1 .6 .6 .6| the lights add up to more"})
    void cut(String lines, String reason) throws IOException {
        assertEquals(0, run(file("b.scene", HEAD + lines.replace(';', '\n')), "-o", picture, "--quiet", "--repeat", "2"));
        assertTrue(err().contains("warning: most of the picture is cut at 1: " + reason.trim()), err());
    }

    @Test
    void whyAPictureIsBlackIsToldInLessTimeThanItTakes() throws IOException {
        StringBuilder text = new StringBuilder("size 640 480\ncamera 0 0 5 0 0 0 0 1 0 45\ndiffuse 1 1 1\nsphere 0 0 0 1\n");
        for (int i = 0; i < 50; i++) {
            text.append("point " + i + " 2 -3000 1 1 1\n");
        }
        long start = System.nanoTime();
        assertEquals(0, run(file("b.scene", text.toString()), "-o", picture, "--quiet"));
        assertTrue(System.nanoTime() - start < 2e9, "seconds: " + (System.nanoTime() - start) / 1e9);
        assertTrue(err().contains("all lights are behind the surfaces"), err());
    }

    @Test
    void whatTheCommandLineOverridesCounts() throws IOException {
        // Without mirrors the box around the eye is all that is seen, and it returns nothing.
        String mirrors = file("b.scene", HEAD + "maxdepth 2\nspecular 1 1 1\nsphere 0 0 0 1\nambient 1 1 1\nsphere 0 0 50 30\n");
        assertEquals(0, run(mirrors, "-o", picture, "--quiet", "--maxdepth", "1"));
        assertTrue(err().contains("nothing that is seen has a diffuse or ambient colour; colours hold for the shapes after"
                + " them, and that on line 5 comes before any"), err());
    }

    @Test
    void aPictureThatIsNotBlackIsNot() {
        assertEquals(0, run(scene, "-o", picture, "--quiet"));
        assertEquals("", err());
    }

    @Test
    void anUnknownWordIsOneError() throws IOException {
        assertEquals(2, run(file("b.scene", HEAD + "Shadow true\ncone 1\n".repeat(1492))));
        assertTrue(err().contains(":3:1: expected a command, found 'Shadow' (on 1492 lines); did you mean 'shadow'?"), err());
        assertEquals(2, err().lines().filter(line -> line.contains("expected")).count(), err());
    }

    @Test
    void readingStopsWhereAThousandThingsAreWrong() {
        Random random = new Random(1);
        InputStream before = System.in;
        try {
            System.setIn(new InputStream() {
                @Override
                public int read() {
                    return random.nextInt(256);
                }
            });
            assertEquals(2, run("-", "-o", picture));
        } finally {
            System.setIn(before);
        }
        assertTrue(err().contains("980 more errors; the rest was not read"), err());
    }

    @Test
    void aPictureIsNoScene() throws IOException {
        assertEquals(0, run(scene, "-o", picture));
        assertEquals(2, run(picture));
        assertTrue(err().contains(picture + ":1:1: expected a scene, found a PNG picture; -o FILE names the output"), err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"\r", "\r\n", "\n"})
    void aLineEndsAsOnAnySystem(String end) throws IOException {
        String text = HEAD + "# of a long time ago\n\nambient .5 .5 .5\nsphere 0 0 0 1\nspher\n";
        assertEquals(2, run(file("b.scene", text.replace("\n", end))));
        assertTrue(err().contains("b.scene:7:1: expected a command, found 'spher'"), err());
        assertEquals(1, err().lines().filter(line -> line.contains("expected")).count(), err());
    }

    @Test
    void onlyWhatIsMissingIsMissing() throws IOException {
        assertEquals(2, run(file("b.scene", HEAD + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\ntri 0 1 2\n")));
        assertEquals(1, err().lines().filter(line -> line.contains("expected")).count(), err());
    }

    @Test
    void aCheckTellsWhatWasReadIfAsked() {
        assertEquals(0, run(scene, "--check", "--verbose"));
        assertTrue(err().contains(
                scene + ": 32x24 output.png, 1 sphere, 0 planes, 0 triangles, 1 light".replace("1 light", "0 lights")), err());
        assertFalse(err().contains("1 spheres"));
    }
}
