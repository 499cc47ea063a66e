package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracer.image.Image;
import raytracer.parser.SceneParser;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/**
 * The project's own scenes against images that the exact judge made in 104 bits, and an independent renderer in 128
 * ({@code src/test/scripts/regenerate-references}). Not one pixel may differ.
 */
class ReferenceTest {

    private static final Path SCENES = Path.of("scenes");

    /** Where a failing test leaves NAME-actual.png, NAME-expected.png and NAME-difference.png. */
    private static final Path FAILURES = Path.of("target", "reference-failures");

    static List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(SCENES)) {
            return files.map(f -> f.getFileName().toString()).filter(f -> f.endsWith(".scene"))
                    .map(f -> f.substring(0, f.length() - ".scene".length())).sorted().toList();
        }
    }

    @Test
    @DisplayName("every scene is compared")
    void thereAreScenes() throws IOException {
        assertTrue(names().size() >= 8 && names().contains("final"), names().toString());
    }

    @ParameterizedTest(name = "{0}.scene")
    @MethodSource("names")
    void equalsTheExactImage(String name) throws Exception {
        Scene scene;
        try (InputStream in = Files.newInputStream(SCENES.resolve(name + ".scene"))) {
            scene = SceneParser.parse(name, in).scene();
        }
        assertEquals(name + ".png", scene.output());
        BufferedImage expected = ImageIO.read(SCENES.resolve(name + ".png").toFile());
        BufferedImage actual = render(scene, 2).toBufferedImage();
        assertEquals(expected.getWidth() + "x" + expected.getHeight(), actual.getWidth() + "x" + actual.getHeight());
        Difference difference = Difference.between(actual, expected);
        if (difference.pixels() > 0) {
            Files.createDirectories(FAILURES);
            write(actual, name + "-actual");
            write(expected, name + "-expected");
            write(difference.picture(), name + "-difference");
        }
        assertEquals(0, difference.pixels(), () -> difference + "; see " + FAILURES);
    }

    @ParameterizedTest(name = "final.scene with {0} threads")
    @org.junit.jupiter.params.provider.ValueSource(ints = {1, 3, 7})
    void doesNotDependOnThreads(int threads) throws Exception {
        Scene scene;
        try (InputStream in = Files.newInputStream(SCENES.resolve("final.scene"))) {
            scene = SceneParser.parse("final", in).scene().withSize(160, 120);
        }
        Image one = render(scene, 1);
        assertEquals(0, Difference.between(render(scene, threads).toBufferedImage(), one.toBufferedImage()).pixels());
        assertEquals(0, one.undefinedPixels());
    }

    private static Image render(Scene scene, int threads) {
        Image image = new Image(scene.width(), scene.height());
        Renderer renderer = Rendering.of(Tracer.compile(scene), threads, image);
        assertEquals((long) scene.width() * scene.height(), renderer.render().primary());
        assertEquals(1, renderer.progress());
        return image;
    }

    private static void write(BufferedImage image, String name) throws IOException {
        File file = FAILURES.resolve(name + ".png").toFile();
        assertTrue(ImageIO.write(image, "png", file));
    }
}
