package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** --explain. */
class ExplainTest extends CommandLine {

    ExplainTest() {
        super("""
                # every kind of shape and light
                size 40 30
                camera 0 1 6  0 1 0  0 1 0  45
                maxdepth 3
                directional 0 1 0  .5 .5 .5
                point 0 4 4  .6 .6 .6
                diffuse .5 .5 .5
                plane 0 0 0  0 1 0
                specular .5 .5 .5
                sphere 0 1 0  1
                maxverts 3
                vertex -3 0 -1
                vertex 3 0 -1
                vertex 0 9 -1
                tri 0 1 2
                """);
    }

    @Test
    @DisplayName("names the lines of shapes and lights, and ends with the picture's bytes")
    void namesLines() throws IOException {
        assertEquals(0, run(scene, "--explain", "20,27"));
        List<String> lines = out().lines().toList();
        assertEquals(scene + ": pixel 20,27 of 40x30", lines.get(0));
        assertTrue(lines.get(1).startsWith("1  ray from the eye (0, 1, 6) towards (0."), lines.get(1));
        assertTrue(lines.get(2).startsWith("   hits plane (" + scene + ":8) at distance "), lines.get(2));
        assertEquals("   ambient   (0, 0, 0)", lines.get(3));
        assertTrue(lines.get(4).startsWith("   directional (" + scene + ":5) adds diffuse (0.25, 0.25, 0.25)"), lines.get(4));
        assertTrue(lines.get(5).startsWith("   point (" + scene + ":6) adds diffuse ("), lines.get(5));
        assertEquals("   mirror    (0, 0, 0): none, as 'specular' is black", lines.get(6));
        assertTrue(lines.get(7).startsWith("colour ("), lines.get(7));
    }

    @Test
    @DisplayName("prints what README shows, but for the last of six digits, which rounding may turn")
    void printsWhatReadmeShows() throws IOException {
        List<String> page = Files.readAllLines(Path.of("README.md"));
        int command = page.indexOf("    $ java -jar target/raytracer.jar scenes/first.scene --explain 230,262");
        assertEquals(0, run("scenes/first.scene", "--explain", "230,262"));
        List<String> lines = out().lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            assertEquals(shortened(page.get(command + 1 + i).strip()), shortened(lines.get(i).strip()));
        }
    }

    /** Without what follows the fifth decimal; a number that is nothing but rounding is nothing. */
    private static String shortened(String line) {
        return line.replaceAll("-?[0-9.]+E-[0-9]+", "0").replaceAll("(\\.[0-9]{5})[0-9]+", "$1");
    }

    @Test
    void followsNoMirrorThatCannotChangeThePixel() throws IOException {
        Path bright = folder.resolve("bright.scene");
        Files.writeString(bright, "size 4 4\ncamera 0 0 5 0 0 0 0 1 0 45\nmaxdepth 2\nambient 1 1 1\nspecular .5 .5 .5\n"
                + "sphere 0 0 0 9\n");
        assertEquals(0, run(bright.toString(), "--explain", "1,1"));
        assertTrue(out().contains("mirror    (0.5, 0.5, 0.5): not followed, as it can change the pixel no more"), out());
        assertEquals(6, out().lines().count(), out());
    }

    @Test
    void followsMirrorsAsDeepAsAllowed() {
        assertEquals(0, run(scene, "--explain", "20,16"));
        assertTrue(out().contains("1  ray from") && out().contains("hits sphere (" + scene + ":10)"), out());
        assertTrue(out().contains("2  mirrored ray from"), out());
        assertEquals(0, run(scene, "--explain", "20,16", "--maxdepth", "1"));
        assertTrue(out().contains("not followed, as maxdepth is 1"), out());
        assertEquals(0, run(scene, "--explain", "20,2"));
        assertTrue(out().contains("hits tri (" + scene + ":15)"), out());
    }

    @ParameterizedTest
    @CsvSource({"20,27", "20,16", "0,0", "39,29", "13,20", "20,2"})
    void endsWithThePicturesBytes(int x, int y) throws IOException {
        assertEquals(0, run(scene, "-o", picture));
        int rgb = ImageIO.read(new java.io.File(picture)).getRGB(x, y);
        assertEquals(0, run(scene, "--explain", x + "," + y));
        assertTrue(out().strip().endsWith(" -> " + (rgb >> 16 & 255) + " " + (rgb >> 8 & 255) + " " + (rgb & 255)), out());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--explain 40,1| expected --explain to be inside the picture of 40x30",
        "--explain 4| expected --explain to be like 100,85",
        "--explain 4,4 --samples 4| --explain goes without --samples",
        "--explain 4,4 -o x.png| --explain goes without --output"})
    void refusesWhatMakesNoSense(String args, String message) {
        assertRefused(args, message);
    }

    @Test
    void isNamedByAComparison() throws IOException {
        assertEquals(0, run(scene, "-o", picture));
        Path other = folder.resolve("b.png");
        Files.copy(Path.of(picture), other);
        assertEquals(3, run(scene, "-o", picture, "--maxdepth", "1", "--compare", other.toString()));
        assertTrue(err().contains("--explain "), err());
    }
}
