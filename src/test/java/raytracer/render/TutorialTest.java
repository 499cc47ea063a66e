package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import raytracer.image.Image;
import raytracer.parser.ParsedScene;
import raytracer.parser.Scenes;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/** README's tutorial. */
class TutorialTest {

    private static final Path PICTURES = Path.of("src/site/pictures");

    /** What the file holds after each step. */
    private static List<String> steps() throws IOException {
        String page = Files.readString(Path.of("README.md"));
        String section = page.substring(page.indexOf("## The format, step by step"), page.indexOf("What there is:"));
        List<String> steps = new ArrayList<>();
        StringBuilder file = new StringBuilder();
        for (String line : section.lines().toList()) {
            if (line.startsWith("    ")) {
                file.append(line.strip()).append('\n');
            } else if (line.startsWith("![")) {
                steps.add(file.toString());
            }
        }
        return steps;
    }

    private static String withoutComments(String scene) {
        return scene.lines().map(line -> line.replaceAll("#.*", "").replaceAll(" +", " ").strip())
                .filter(line -> !line.isEmpty() && !line.startsWith("output")).collect(Collectors.joining("\n"));
    }

    @Test
    @DisplayName("ends with tutorial.scene")
    void endsWithTheScene() throws IOException {
        List<String> steps = steps();
        assertEquals(withoutComments(Files.readString(Path.of("scenes/tutorial.scene"))),
                withoutComments(steps.get(steps.size() - 1)));
    }

    @Test
    @DisplayName("shows each step as it is rendered, and no step has a warning")
    void showsEachStep() throws Exception {
        List<String> steps = steps();
        assertTrue(steps.size() > 4, steps.size() + " steps");
        for (int n = 1; n <= steps.size(); n++) {
            ParsedScene parsed = Scenes.parse(steps.get(n - 1));
            assertEquals(List.of(), parsed.warnings());
            BufferedImage shown = ImageIO.read(PICTURES.resolve("tutorial-" + n + ".png").toFile());
            Scene scene = parsed.scene();
            Image image = new Image(scene.width(), scene.height());
            Rendering.of(Tracer.compile(scene), 1, image).render();
            assertEquals(0, Difference.between(image.toBufferedImage(), shown).pixels(), "step " + n);
        }
    }
}
