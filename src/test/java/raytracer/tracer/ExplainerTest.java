package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.image.Image;
import raytracer.parser.Scenes;
import raytracer.scene.Colour;
import raytracer.scene.Scene;

/** What explains a pixel. */
class ExplainerTest {

    private static final int WIDTH = 32;
    private static final int HEIGHT = 24;

    /** The plain statement of shading: what all steps bring, each by its weight. */
    private static double[] sum(List<Explainer.Step> steps) {
        double[] sum = new double[3];
        for (Explainer.Step step : steps) {
            if (step.hit() != null) {
                Colour ambient = step.hit().material().ambient();
                double[] local = {ambient.red(), ambient.green(), ambient.blue()};
                for (Explainer.Lit light : step.lights()) {
                    local[0] += light.diffuse().red() + light.highlight().red();
                    local[1] += light.diffuse().green() + light.highlight().green();
                    local[2] += light.diffuse().blue() + light.highlight().blue();
                }
                sum[0] += step.weight().red() * local[0];
                sum[1] += step.weight().green() * local[1];
                sum[2] += step.weight().blue() * local[2];
            }
        }
        return sum;
    }

    private static void assertAddsUp(Scene scene) {
        Image picture = new Image(scene.width(), scene.height()), sums = new Image(scene.width(), scene.height());
        double[] traced = Pictures.trace(scene);
        Explainer explainer = Tracer.compile(scene).newExplainer();
        for (int y = 0; y < scene.height(); y++) {
            for (int x = 0; x < scene.width(); x++) {
                int i = 3 * (y * scene.width() + x);
                double[] sum = sum(explainer.explain(x, y).steps());
                picture.setPixels(x, y, 1, 1, new double[] {traced[i]}, new double[] {traced[i + 1]},
                        new double[] {traced[i + 2]});
                sums.setPixels(x, y, 1, 1, new double[] {sum[0]}, new double[] {sum[1]}, new double[] {sum[2]});
                assertEquals(Integer.toHexString(picture.rgb(x, y)), Integer.toHexString(sums.rgb(x, y)),
                        "pixel " + x + "," + y);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"final", "first", "island", "sunflower", "kaleidoscope", "planet", "materials", "lights",
        "inside", "star", "corners"})
    @DisplayName("adds up to its bytes in the picture, in every pixel of our scenes")
    void addsUp(String name) throws Exception {
        Scene scene = Scenes.parse(Files.readString(Path.of("scenes", name + ".scene"))).scene();
        assertAddsUp(scene.withSize(WIDTH, HEIGHT));
    }

    @Test
    @DisplayName("adds up where a lattice of mirrors has ties everywhere")
    void addsUpWithTies() throws Exception {
        StringBuilder text = new StringBuilder("size 24 24\ncamera 0 0 8 0 0 0 0 1 0 40\nmaxdepth 5\npoint 0 9 9 1 1 1\n"
                + "specular .5 .5 .5\n");
        for (int i = 0; i < 27; i++) {
            text.append("diffuse .").append(1 + i % 9).append(" .5 .5\nsphere ").append(i % 3 - 1).append(' ')
                    .append(i / 3 % 3 - 1).append(' ').append(i / 9 - 1).append(" .5\n");
        }
        assertAddsUp(Scenes.parse(text.toString()).scene());
    }

    @Test
    void namesWhatIsAsNear() throws Exception {
        Scene scene = Scenes.parse("size 1 1\ncamera 0 0 5 0 0 0 0 1 0 45\nambient 1 0 0\nsphere 0 0 0 1\n"
                + "plane 0 0 1 0 0 1\nsphere 0 0 -3 1\n").scene();
        Explainer.Step step = Tracer.compile(scene).newExplainer().explain(0, 0).steps().get(0);
        assertEquals(0, step.hit().surface());
        assertEquals(List.of(1), step.asNear());
    }

    @Test
    void namesWhatBlocksALight() throws Exception {
        Scene scene = Scenes.parse("size 1 1\ncamera 0 0 5 0 0 0 0 1 0 45\npoint 0 0 9 1 1 1\npoint 0 8 0 1 1 1\n"
                + "directional 0 0 1 1 1 1\ndiffuse 1 1 1\nplane 0 0 0 0 0 1\nsphere 0 0 7 .5\n").scene();
        List<Explainer.Lit> lights = Tracer.compile(scene).newExplainer().explain(0, 0).steps().get(0).lights();
        assertTrue(lights.get(0).isBlocked());
        assertEquals(1, lights.get(0).blocker());
        assertEquals(6.5, lights.get(0).blockedAt(), 1e-12);
        assertEquals(9, lights.get(0).distance(), 1e-12);
        assertTrue(!lights.get(1).isBlocked() && !lights.get(1).isFacing(), "it is in the plane");
        assertEquals(1, lights.get(2).blocker());
    }
}
