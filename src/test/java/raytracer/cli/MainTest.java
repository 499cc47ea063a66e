package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.console.ProgressBar;

/** The command line. */
class MainTest extends CommandLine {

    private static final String SCENE = """
            size 8 6
            camera 0 0 5 0 0 0 0 1 0 45
            point 1 2 5 1 1 1
            maxdepth 2
            diffuse .5 .5 .5
            specular .2 .2 .2
            sphere 0 0 0 1
            plane 0 -1 0 0 1 0
            """;

    MainTest() {
        super(SCENE);
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void rendersToThePlaceItIsTold() throws IOException {
        assertEquals(0, run(scene, "-o", picture));
        assertEquals(8, ImageIO.read(Path.of(picture).toFile()).getWidth());
        assertTrue(err().matches(".*a\\.png 8x6 in \\d+\\.\\d s, 104 rays\\R"), err());
        assertEquals("", out.toString(StandardCharsets.UTF_8));
        assertEquals(List.of("a.png", "a.scene"), files());
    }

    @Test
    void rendersToTheScenesOutputInTheWorkingDirectory() throws IOException {
        Path output = Path.of("target", "main-test-output.png");
        Files.deleteIfExists(output);
        assertEquals(0, run(file("b.scene", SCENE + "output target/main-test-output.png\n"), "--quiet"));
        assertTrue(Files.deleteIfExists(output));
    }

    @ParameterizedTest
    @CsvSource({"/tmp/x.png", "../x.png", "target/../../x.png"})
    void keepsTheScenesOutputInsideTheWorkingDirectory(String output) throws IOException {
        String other = file("b.scene", SCENE + "output " + output + "\n");
        assertEquals(2, run(other));
        assertTrue(err().contains("expected 'output' to be inside the working directory, found '" + output + "'"));
        assertEquals(0, run(other, "-o", picture));
    }

    @Test
    void overridesSizeAndDepth() throws IOException {
        assertEquals(0, run(scene, "-o", picture, "--size", "5x4", "--quiet"));
        assertEquals(5, ImageIO.read(Path.of(picture).toFile()).getWidth());
        assertEquals(4, ImageIO.read(Path.of(picture).toFile()).getHeight());
        byte[] mirrors = Files.readAllBytes(Path.of(picture));
        assertEquals(0, run(scene, "--output=" + picture, "--size=5x4", "--maxdepth=1", "--quiet"));
        assertFalse(java.util.Arrays.equals(mirrors, Files.readAllBytes(Path.of(picture))));
    }

    @Test
    void writesTheSameBytesWithAnyNumberOfThreads() throws IOException {
        run(scene, "-o", picture, "--threads", "1", "--size", "100x70");
        byte[] one = Files.readAllBytes(Path.of(picture));
        run(scene, "-o", picture, "--threads", "7", "--size", "100x70", "--repeat", "2");
        assertArrayEquals(one, Files.readAllBytes(Path.of(picture)));
    }

    @Test
    void writesStatsAsJson() throws IOException {
        String stats = folder.resolve("stats.json").toString();
        assertEquals(0, run(scene, "-o", picture, "--quiet", "--stats", stats, "--repeat", "3", "--threads", "2"));
        String json = Files.readString(Path.of(stats)).replaceAll("\\d+\\.\\d{4}", "T");
        assertEquals("""
                {
                  "program": "(development)",
                  "java": "%s",
                  "scene": "%s",
                  "width": 8,
                  "height": 6,
                  "threads": 2,
                  "samples": 1,
                  "parseMillis": T,
                  "buildMillis": T,
                  "renderMillis": [T, T, T],
                  "writeMillis": T,
                  "rays": {"primary": 48, "shadow": S, "reflection": R},
                  "triangles": 0,
                  "spheres": 1,
                  "planes": 1,
                  "lights": 1
                }
                """.formatted(Runtime.version(), scene), json.replaceAll("shadow\": \\d+", "shadow\": S")
                .replaceAll("reflection\": \\d+", "reflection\": R"));
    }

    @Test
    void checksWithoutWriting() throws IOException {
        assertEquals(0, run("--check", scene));
        assertEquals(List.of("a.scene"), files());
        assertEquals("", err());
        assertEquals(2, run("--check", file("b.scene", "size 1\n")));
    }

    @Test
    void showsEveryErrorOfASceneAndWritesNothing() throws IOException {
        String bad = file("b.scene", SCENE + "sphere 0 0 0\nspher 1\n" + "vertex 0\n".repeat(20));
        assertEquals(2, run(bad, "-o", picture));
        assertTrue(err().startsWith(bad + ":9:8: expected 4 numbers after 'sphere' (x y z r), found 3\n"
                + "sphere 0 0 0\n       ^~~~~\n" + bad + ":10:1: expected a command, found 'spher'; did you mean"
                + " 'sphere'?\nspher 1\n^~~~~\n"), err());
        assertTrue(err().endsWith(bad + ": 2 more errors" + System.lineSeparator()), err());
        assertFalse(Files.exists(Path.of(picture)));
    }

    @Test
    void rendersOtherScenesThoughOneIsBad() throws IOException {
        String good = file("good.scene", SCENE + "output target/main-test-good.png\n");
        assertEquals(2, run(file("bad.scene", "size\n"), good, "--quiet"));
        assertTrue(Files.deleteIfExists(Path.of("target", "main-test-good.png")));
        assertEquals(1, run(folder.resolve("missing.scene").toString(), good, "--quiet"));
        assertTrue(Files.deleteIfExists(Path.of("target", "main-test-good.png")));
        assertTrue(err().contains("missing.scene: cannot read the scene: no such file or directory"));
    }

    @Test
    void replacesAPictureWholeOrNotAtAll() throws IOException {
        Files.writeString(Path.of(picture), "old");
        assertEquals(2, run(file("bad.scene", "size\n"), "-o", picture));
        assertEquals("old", Files.readString(Path.of(picture)));
        assertEquals(0, run(scene, "-o", picture));
        assertEquals(8, ImageIO.read(Path.of(picture).toFile()).getWidth());
    }

    @Test
    void saysWhatIsWrongWithAPlace() throws IOException {
        assertEquals(1, run(folder.toString()));
        assertTrue(err().contains("expected a scene file, found a directory"));
        assertEquals(1, run(scene, "-o", folder.toString()));
        assertTrue(err().contains("it is a directory"));
        assertEquals(1, run(scene, "-o", folder.resolve("none/x.png").toString()));
        assertTrue(err().contains("there is no directory"));
        assertEquals(List.of("a.scene"), files());
    }

    @Test
    void refusesAPictureThatIsTooLargeBeforeRendering() {
        assertEquals(1, run(scene, "-o", picture, "--size", "2147483647x2147483647"));
        assertTrue(err().contains("a picture of 2147483647x2147483647 pixels is too large"), err());
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '"', value = {
        "--size 0x5, expected the width of --size to be a whole number from 1 to 2147483647, ",
        "--size 640, expected --size to be like 640x480",
        "--maxdepth 0, expected --maxdepth to be a whole number from 1",
        "--threads -2, expected --threads to be a whole number from 1",
        "--threads 9999999999, expected --threads to be a whole number from 1",
        "--repeat many, expected --repeat to be a whole number from 1",
        "--samples 64 --size 100000000x1, expected --samples N to be at most 21 for a picture of 100000000x1",
        "--quiet=yes, --quiet takes no value",
        "--frobnicate, unknown option '--frobnicate'; see --help",
        "--exlpain 1 1, unknown option '--exlpain'; did you mean '--explain'?",
        "-o --quiet, expected a value after -o but found the option --quiet",
        "--stats -o x.png, expected a value after --stats but found the option -o",
        "-o x.jpg, expected -o to name a PNG but found 'x.jpg'",
        "-o - --stats -, expected one of --output and --stats to be '-' but found both",
        "--check --stats s.json, --check goes without --stats",
        "--camera 0	0	5	0	0	0	0	1	0	180, --camera:1:26: expected fov of 'camera' to be between 0 and 180 degrees",
        "-x, unknown option '-x'",
        "--stats, expected a value after --stats"})
    void refusesWhatMakesNoSense(String args, String message) {
        assertRefused(args, message.replace(" but", ","));
    }

    @Test
    void saysWhatAnOptionHasSwallowed() {
        assertEquals(2, run("--samples", scene));
        assertTrue(err().contains("expected --samples, if not 'auto', to be a whole number from 1 to 64, found '" + scene + "'"), err());
        assertEquals(2, run(""));
        assertTrue(err().contains("expected a scene file, found an empty name"), err());
    }

    @Test
    void takesAnotherCamera() throws IOException {
        String moved = file("b.scene", SCENE.replace("camera 0 0 5 0 0 0 0 1 0 45", "camera 1 2 5 0 .5 0 0 1 .1 30"));
        assertEquals(0, run(moved, "-o", picture));
        byte[] expected = Files.readAllBytes(Path.of(picture));
        assertEquals(0, run(scene, "-o", picture, "--camera", "1 2 5  0 .5 0  0 1 .1  30"));
        assertArrayEquals(expected, Files.readAllBytes(Path.of(picture)));
    }

    @Test
    void writesStatsToStandardOutput() {
        assertEquals(0, run(scene, "-o", picture, "--quiet", "--stats", "-"));
        assertTrue(out.toString(StandardCharsets.UTF_8).startsWith("{\n  \"program\": "), out());
    }

    @Test
    void tellsANameThatIsNoUtf8WhereItStands() throws IOException {
        Path latin = folder.resolve("latin.scene");
        Files.write(latin, (SCENE + "output \u00e9.png\n").getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(2, run(latin.toString()));
        assertTrue(err().startsWith(latin + ":9:8: expected the name of 'output' in UTF-8"), err());
    }

    @Test
    void refusesOneOutputForSeveralScenesAndNoSceneAtAll() {
        assertEquals(2, run(scene, scene, "-o", picture));
        assertEquals(2, run());
        assertEquals(2, run("--quiet"));
        assertEquals(0, run("--help"));
        assertEquals(0, run("--version"));
        assertTrue(out.toString(StandardCharsets.UTF_8).startsWith("usage: raytracer"));
    }

    @Test
    void showsProgressInOneLine() {
        assertEquals("[" + "#".repeat(5) + " ".repeat(15) + "]  25 %, 6 s left  ", ProgressBar.line(.25, 2));
        assertEquals("[" + " ".repeat(20) + "]   0 %  ", ProgressBar.line(0, 2));
    }
}
