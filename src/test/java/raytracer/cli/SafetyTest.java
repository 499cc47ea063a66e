package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that are there. */
class SafetyTest extends CommandLine {

    private static final String SCENE = "size 8 6\ncamera 0 0 5 0 0 0 0 1 0 45\nambient .5 .4 .3\nsphere 0 0 0 1\n";

    SafetyTest() {
        super(SCENE);
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    private String path(String name) {
        return folder.resolve(name).toString();
    }

    @ParameterizedTest(name = "are not replaced by what is written: {0}")
    @CsvSource({
        "-o a.scene, the picture, a.scene",
        "-o b/../a.scene, the picture, a.scene",
        "-o link.scene, the picture, a.scene",
        "-o ref.png --compare ref.png, the picture, ref.png",
        "-o x.png --compare ref.png --diff ref.png, the difference picture, ref.png",
        "-o x.png --compare ref.png --diff x.png, the difference picture, x.png",
        "-o ref.png --compare x-diff.png --diff a.scene, the difference picture, a.scene",
        "-o x.png --stats x.png, the statistics, x.png",
        "-o x.png --stats a.scene, the statistics, a.scene",
        "-o x.png --compare x-diff.png, the difference picture, x-diff.png"})
    void areNotReplaced(String args, String what, String kept) throws IOException {
        Files.createDirectory(folder.resolve("b"));
        Files.createSymbolicLink(folder.resolve("link.scene"), folder.resolve("a.scene"));
        assertEquals(0, run(scene, "-o", path("ref.png")));
        Files.copy(folder.resolve("ref.png"), folder.resolve("x-diff.png"));
        List<String> before = files();
        byte[] old = Files.readAllBytes(folder.resolve("ref.png"));
        String[] words = (scene + " " + args.replaceAll("(?<= )(?=[a-z]+[-a-z./]*\\.)", folder + "/")).split(" ");
        assertEquals(2, run(words), String.join(" ", words));
        assertTrue(err().contains(what) && err().contains(kept) && err().contains("would replace"), err());
        assertEquals(before, files());
        assertEquals(SCENE, Files.readString(folder.resolve("a.scene")));
        assertArrayEquals(old, Files.readAllBytes(folder.resolve("ref.png")));
    }

    @Test
    void areNotWrittenTwiceInOneRun() throws IOException {
        String one = file("one.scene", SCENE + "output target/safety-test.png\n");
        String two = file("two.scene", SCENE + "output target/../target/safety-test.png\n".replace("../target/", "./"));
        assertEquals(2, run(one, two));
        assertTrue(err().contains("one.scene") && err().contains("two.scene"), err());
        assertFalse(Files.exists(Path.of("target", "safety-test.png")));
    }

    @ParameterizedTest(name = "are safe from a scene''s own output {0}")
    @CsvSource({"x.jpg, to end in '.png'", "pics/, to end in '.png'", "a.scene, to end in '.png'",
        "a\u001b[31m.png, to have no control characters", "../x.png, to be inside the working directory",
        "/tmp/x.png, to be inside the working directory", "target/safety-link.png, to be inside the working directory"})
    void areSafeFromAScenesOutput(String output, String message) throws IOException {
        Path link = Path.of("target", "safety-link.png");
        Files.deleteIfExists(link);
        Files.createSymbolicLink(link, folder.resolve("elsewhere.png"));
        Files.writeString(folder.resolve("elsewhere.png"), "precious");
        String hostile = file("b.scene", SCENE + "output " + output + "\n");
        assertEquals(2, run(hostile));
        assertTrue(err().startsWith(hostile + ":5:8: expected 'output' " + message), err());
        assertFalse(err().contains("\u001b"), "a control character");
        assertEquals("precious", Files.readString(folder.resolve("elsewhere.png")));
        Files.delete(link);
    }

    @Test
    void keepTheirMode() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Files.writeString(Path.of(picture), "old");
        Files.setPosixFilePermissions(Path.of(picture), PosixFilePermissions.fromString("rw-r-----"));
        assertEquals(0, run(scene, "-o", picture));
        assertEquals("rw-r-----", PosixFilePermissions.toString(Files.getPosixFilePermissions(Path.of(picture))));
    }

    @Test
    void areKeptIfTheyAreWriteProtected() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Files.writeString(Path.of(picture), "old");
        Files.setPosixFilePermissions(Path.of(picture), PosixFilePermissions.fromString("r--r--r--"));
        assertEquals(1, run(scene, "-o", picture));
        assertTrue(err().contains("it is write-protected"), err());
        assertEquals("old", Files.readString(Path.of(picture)));
    }

    @Test
    void areWrittenThroughLinksEvenIfThoseDangle() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("link.png"), Path.of("a.png"));
        assertEquals(0, run(scene, "-o", link.toString()));
        assertTrue(Files.isSymbolicLink(link));
        assertEquals(8, ImageIO.read(Path.of(picture).toFile()).getWidth());
    }

    @Test
    void mayHaveNamesAsLongAsTheSystemAllows() throws IOException {
        String longest = "x".repeat(251) + ".png";
        assertEquals(0, run(scene, "-o", path(longest)), err());
        assertEquals(List.of("a.scene", longest), files());
    }

    @Test
    void areNoDevices() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/null")));
        assertEquals(0, run(scene, "-o", path("ref.png"), "--size", "8x6"));
        assertEquals(3, run(scene, "-o", "/dev/null", "--compare", path("ref.png"), "--size", "8x5"));
        assertEquals(3, run(file("b.scene", SCENE.replace(".5", ".6")), "-o", "/dev/null", "--compare", path("ref.png")));
        assertFalse(Files.exists(Path.of("/dev/null-diff.png")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"none/c.svg", "a.svg"})
    @DisplayName("a chart looks at its place before it measures")
    void aChartLooksAtItsPlaceFirst(String chart) throws IOException {
        Files.createDirectory(folder.resolve("a.svg"));
        long start = System.nanoTime();
        assertEquals(1, run(scene, "--chart", path(chart), "--chart-seconds", "60"));
        assertTrue(System.nanoTime() - start < 5_000_000_000L, "at once");
        assertTrue(err().contains("cannot write"), err());
    }
}
