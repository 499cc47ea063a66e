package raytracer;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A page. */
class PagesTest {

    private static final Path MAIN = Path.of("src/main/java/raytracer"), TESTS = Path.of("src/test/java/raytracer");

    static List<Path> pages() throws IOException {
        try (Stream<Path> pages = Files.list(Path.of("src/site/markdown"))) {
            return Stream.concat(Stream.of(Path.of("README.md")), pages.sorted()).toList();
        }
    }

    static List<Path> files() throws IOException {
        try (Stream<Path> all = Files.walk(Path.of("src"))) {
            return Stream.concat(Stream.of(Path.of("README.md"), Path.of("pom.xml")),
                    all.filter(Files::isRegularFile).filter(f -> f.toString().matches(".*\\.(java|md|csv|svg|properties)|.*/scripts/.*"))
                            .sorted()).toList();
        }
    }

    @ParameterizedTest(name = "has no dead link: {0}")
    @MethodSource("pages")
    void hasNoDeadLink(Path page) throws IOException {
        Matcher link = Pattern.compile("\\]\\(([^)#]+)(#[^)]*)?\\)").matcher(Files.readString(page));
        while (link.find()) {
            Path target = page.resolveSibling(link.group(1)).normalize();
            assertTrue(link.group(1).startsWith("http") || Files.exists(target), page + " links to " + link.group(1));
        }
    }

    @ParameterizedTest(name = "names only tests that there are: {0}")
    @MethodSource("pages")
    void namesOnlyTestsThatThereAre(Path page) throws IOException {
        Matcher test = Pattern.compile("-Dtest=(\\w+)").matcher(Files.readString(page));
        while (test.find()) {
            assertTrue(exists(TESTS, test.group(1) + ".java"), page + " names " + test.group(1));
        }
    }

    @ParameterizedTest(name = "names only classes that there are: {0}")
    @MethodSource("pages")
    void namesOnlyClassesThatThereAre(Path page) throws IOException {
        Matcher name = Pattern.compile("`((?:[a-z]+/)+[A-Z]\\w+)").matcher(Files.readString(page));
        while (name.find()) {
            String file = name.group(1) + ".java";
            assertTrue(Files.exists(MAIN.resolve(file)) || Files.exists(TESTS.resolve(file)), page + " names " + name.group(1));
        }
    }

    /** Whoever has the clone has nothing else. */
    @ParameterizedTest(name = "names nothing outside of the repository: {0}")
    @MethodSource("files")
    void namesNothingOutside(Path file) throws IOException {
        assertFalse(Files.readString(file).contains("../" + "shared"), file.toString());
    }

    private static boolean exists(Path folder, String name) {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.anyMatch(file -> file.getFileName().toString().equals(name));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
