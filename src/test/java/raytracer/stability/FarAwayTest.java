package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.image.Image;
import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/** Far from the origin, where coordinates are coarse. */
class FarAwayTest {

    private static final int WIDTH = 48;
    private static final int HEIGHT = 36;

    private static String spheres(double x, String radius) {
        Random random = new Random(7);
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT,
                "size %d %d%ncamera %s 0 60 %s 0 0 0 1 0 45%ndirectional 0 0 1 1 1 1%ndiffuse .5 .5 .5%n", WIDTH, HEIGHT, x, x));
        for (int i = 0; i < 2000; i++) {
            text.append(String.format(Locale.ROOT, "sphere %s %s %s %s%n", x + (random.nextInt(161) - 80) / 4.0,
                    random.nextInt(161) / 4.0 - 20, random.nextInt(161) / 4.0 - 20, radius));
        }
        return text.toString();
    }

    private static int[] render(Scene scene) {
        Image image = new Image(WIDTH, HEIGHT);
        new Renderer(Tracer.compile(scene), Sampling.CENTRES, 1, Region.whole(WIDTH, HEIGHT), image).render();
        int[] pixels = new int[WIDTH * HEIGHT];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = image.rgb(i % WIDTH, i / WIDTH);
        }
        return pixels;
    }

    @ParameterizedTest(name = "moved by {0}, where all coordinates are exact, a scene has the same picture")
    @ValueSource(doubles = {0x1p10, 0x1p20, 0x1p30})
    void isTheSameWhenMoved(double x) throws Exception {
        assertArrayEquals(render(Scenes.parse(spheres(0, ".25")).scene()), render(Scenes.parse(spheres(x, ".25")).scene()));
    }
}
