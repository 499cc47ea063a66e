package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracer.exact.ExactRenderer;
import raytracer.image.Image;
import raytracer.parser.SceneParser;
import raytracer.render.Rendering;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/**
 * Random scenes against the format in 104 bits, pixel for pixel. {@code mvn test -Dseeds=500} tries that many scenes of
 * each family.
 */
class RandomSceneTest {

    private static final int SEEDS = Integer.getInteger("seeds", 40);

    // An odd size, so that a ray passes exactly through the middle.
    private static final int WIDTH = 25;
    private static final int HEIGHT = 19;

    // Small, large and far away. Powers of two leave whole numbers whole, and so exact ties exact.
    private static final double[] SCALES = {1, 0x1p-20, 0x1p23, 1, 1};
    private static final double[] OFFSETS = {0, 0, 0, 1e3, 1e6};

    @ParameterizedTest
    @EnumSource
    void family(Families family) {
        long[] wrong = IntStream.range(0, SEEDS).parallel().mapToLong(seed -> wrongPixels(family, seed)).toArray();
        for (int seed = 0; seed < SEEDS; seed++) {
            if (wrong[seed] > 0) {
                System.out.println(family + " seed " + seed + ": " + wrong[seed] + " wrong");
            }
        }
        assertEquals(0, IntStream.range(0, SEEDS).filter(seed -> wrong[seed] > 0).count(), "scenes with a wrong pixel");
    }

    private static long wrongPixels(Families family, int seed) {
        int variant = seed % SCALES.length;
        String text = family.scene(seed, WIDTH, HEIGHT, SCALES[variant], OFFSETS[variant]);
        Scene scene;
        try {
            scene = SceneParser.parse("random", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))).scene();
        } catch (Exception e) {
            throw new AssertionError(text, e);
        }
        Image image = new Image(WIDTH, HEIGHT);
        Rendering.of(Tracer.compile(scene), 1, image).render();
        ExactRenderer exact = new ExactRenderer(scene);
        return IntStream.range(0, WIDTH * HEIGHT)
                .filter(i -> image.rgb(i % WIDTH, i / WIDTH) != exact.pixel(i % WIDTH, i / WIDTH)).count();
    }
}
