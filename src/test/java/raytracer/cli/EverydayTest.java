package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** In daily use. */
class EverydayTest extends CommandLine {

    private static final String SCENE = """
            size 75 50
            camera 0 1 5 0 0 0 0 1 0 45
            point 1 2 5 1 1 1
            maxdepth 3
            diffuse .5 .4 .3
            specular .3 .3 .3
            shininess 20
            sphere 0 0 0 1
            sphere 1.5 -.5 .5 .5
            plane 0 -1 0 0 1 0
            """;

    EverydayTest() {
        super(SCENE);
    }

    private int[] pixels(String file) throws IOException {
        BufferedImage image = ImageIO.read(Path.of(file).toFile());
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    private String reference() {
        String reference = folder.resolve("reference.png").toString();
        assertEquals(0, run(scene, "-o", reference));
        return reference;
    }

    /** Changes one pixel of a picture. */
    private static void change(String file, int x, int y, int step) throws IOException {
        BufferedImage image = ImageIO.read(Path.of(file).toFile());
        int rgb = image.getRGB(x, y);
        image.setRGB(x, y, (rgb & 255) >= step ? rgb - step : rgb + step);
        ImageIO.write(image, "png", Path.of(file).toFile());
    }

    @Test
    void comparesEqual() {
        String reference = reference();
        assertEquals(0, run(scene, "-o", picture, "--compare", reference));
        assertTrue(out().contains("equals " + reference));
        assertFalse(Files.exists(folder.resolve("a-diff.png")));
    }

    @Test
    void comparesDifferent() throws IOException {
        String reference = reference();
        change(reference, 7, 9, 5);
        assertEquals(3, run(scene, "-o", picture, "--compare", reference));
        assertTrue(out().contains("1 of 3750 pixels differ from " + reference
                + ", by at most 5 of 255 at (7, 9); RMSE 0.0471 of 255; columns 7 to 7, rows 9 to 9"), out());
        int[] difference = pixels(folder.resolve("a-diff.png").toString()), actual = pixels(picture);
        assertEquals(0xFFFF9428, difference[9 * 75 + 7], "the pixel");
        assertEquals(0xFF703000, difference[10 * 75 + 8], "around it");
        int sum = (actual[0] & 255) + (actual[0] >> 8 & 255) + (actual[0] >> 16 & 255);
        assertEquals(0xFF000000 | sum / 12 * 0x010101, difference[0], "elsewhere");
    }

    @Test
    void comparesWithinATolerance() throws IOException {
        String reference = reference();
        change(reference, 7, 9, 5);
        assertEquals(0, run(scene, "-o", picture, "--compare", reference, "--tolerance", "5"));
        assertTrue(out().contains("none by more than the tolerance of 5"), out());
        assertEquals(3, run(scene, "-o", picture, "--compare", reference, "--tolerance", "4"));
    }

    @Test
    void refusesAReferenceThatCannotBeCompared() throws IOException {
        assertEquals(1, run(scene, "-o", picture, "--compare", folder.resolve("none.png").toString()));
        assertTrue(err().contains("no such file"));
        assertEquals(1, run(scene, "-o", picture, "--compare", scene));
        assertTrue(err().contains("it is no PNG"));
        String reference = reference();
        assertEquals(3, run(scene, "-o", picture, "--size", "20x10", "--compare", reference));
        assertTrue(out().contains("differs from " + reference + " in size: 20x10, and that is 75x50"), out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "3", "auto", "auto:0.001"})
    void rendersPartsThatEqualThoseOfTheWhole(String samples) throws IOException {
        assertEquals(0, run(scene, "-o", picture, "--samples", samples));
        int[] whole = pixels(picture);
        for (int[] r : new int[][] {{0, 0, 75, 13}, {17, 21, 40, 29}, {74, 49, 1, 1}, {5, 30, 16, 16}}) {
            assertEquals(0, run(scene, "-o", picture, "--samples", samples, "--region", r[0] + "," + r[1] + "," + r[2] + "," + r[3]));
            int[] part = pixels(picture);
            for (int y = 0; y < r[3]; y++) {
                for (int x = 0; x < r[2]; x++) {
                    assertEquals(whole[(r[1] + y) * 75 + r[0] + x], part[y * r[2] + x]);
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--region 70x0x6x1| expected --region to be like",
        "--region 70,0,6,1| expected --region to be inside the picture of 75x50",
        "--region 0,50,1,1| found columns 0 to 0 and rows 50 to 50",
        "--region 0,0,0,1| expected the width of --region to be a whole number from 1",
        "--samples 65| to be a whole number from 1 to 64",
        "--samples auto:2| expected the error of --samples auto:E to be like 0.002 or 1/255",
        "--samples auto:0/5| expected the error",
        "--tolerance 3| --tolerance goes with --compare",
        "--chart x.png| expected the file of --chart to end in '.svg'",
        "--chart x.svg -o y.png| --chart goes without --output",
        "--chart x.svg --samples 4| --chart goes without --samples",
        "--chart x.svg --repeat 3| --chart goes without --repeat",
        "--chart-seconds 5| --chart-seconds goes with --chart"})
    void refusesWhatMakesNoSense(String args, String message) {
        assertRefused(args, message);
    }

    @ParameterizedTest
    @ValueSource(strings = {"4", "auto:0.002"})
    void samplesAreTheSameOnAnyNumberOfThreads(String samples) throws IOException {
        assertEquals(0, run(scene, "-o", picture, "--samples", samples, "--threads", "1"));
        byte[] one = Files.readAllBytes(Path.of(picture));
        assertEquals(0, run(scene, "-o", picture, "--samples", samples, "--threads", "5"));
        assertArrayEquals(one, Files.readAllBytes(Path.of(picture)));
    }

    @Test
    void streamsTheSameBytesThatItWritesFromMemory() throws IOException {
        assertEquals(0, run(scene, "-o", picture));
        byte[] streamed = Files.readAllBytes(Path.of(picture));
        assertEquals(0, run(scene, "-o", picture, "--repeat", "2"));
        assertArrayEquals(streamed, Files.readAllBytes(Path.of(picture)));
    }

    @Test
    void composesInPipes() throws IOException {
        assertEquals(0, run(scene, "-o", picture));
        InputStream before = System.in;
        try {
            System.setIn(new ByteArrayInputStream(SCENE.getBytes(StandardCharsets.UTF_8)));
            assertEquals(0, run("-", "-o", "-"));
            assertArrayEquals(Files.readAllBytes(Path.of(picture)), out.toByteArray());
            System.setIn(new ByteArrayInputStream("size 1 1\nspher 1".getBytes(StandardCharsets.UTF_8)));
            assertEquals(2, run("-", "-o", "-"));
            assertTrue(err().contains("<stdin>:2:1: "), err());
        } finally {
            System.setIn(before);
        }
    }

    @Test
    void tellsWhatItDoesIfAsked() {
        assertEquals(0, run(scene, "-o", picture, "--verbose"));
        assertTrue(err().contains("2 spheres, 1 plane, 0 triangles, 1 light, maxdepth 3"), err());
        assertTrue(err().contains("\n2 spheres too wide for a tree\n"), err());
        assertTrue(err().contains(", 1 sample a pixel: 3750 rays from the eye"), err());
        assertEquals(0, run(scene, "-o", picture, "--verbose", "--samples", "3"));
        assertTrue(err().contains(", 9 samples a pixel: "), err());
    }

    @Test
    void helpFitsAScreenAndNamesEveryOption() {
        assertEquals(0, run("--help"));
        List<String> lines = out().lines().toList();
        assertTrue(lines.size() <= 24, lines.size() + " lines");
        assertTrue(lines.stream().allMatch(line -> line.length() <= 80));
        for (String option : List.of("--output", "--size", "--maxdepth", "--samples", "--region", "--threads", "--compare", "--diff",
                "--tolerance", "--chart", "--chart-seconds", "--quiet", "--verbose", "--repeat", "--stats", "--check",
                "--help", "--version")) {
            assertTrue(out().contains(option), option);
        }
    }

    @Test
    void chartsTimeAgainstErrorAndNamesASetting() throws IOException {
        Path chart = folder.resolve("c.svg");
        assertEquals(0, run(scene, "--chart", chart.toString(), "--chart-seconds", "3", "--quiet"), err());
        assertTrue(out().startsWith("Cheapest measured with an RMSE below 1/255 over the picture: --samples "), out());
        List<String> table = Files.readAllLines(folder.resolve("c.csv"));
        assertEquals("setting,median ms,lower quartile,upper quartile,rounds,rmse", table.get(1));
        assertTrue(table.stream().anyMatch(line -> line.startsWith("--samples 4 --maxdepth 2,")));
        assertTrue(Files.readString(chart).contains(">RMSE of 1/255<"));
        assertFalse(Files.exists(folder.resolve("output.png")));
    }
}
