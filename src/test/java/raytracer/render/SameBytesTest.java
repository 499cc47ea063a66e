package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracer.image.Image;
import raytracer.parser.Scenes;
import raytracer.scene.Scene;
import raytracer.stability.NearTies;
import raytracer.tracer.Tracer;

/** Where rounding alone decides what is seen, a choice made in turns would show here. */
class SameBytesTest {

    private static final int WIDTH = 200;
    private static final int HEIGHT = 150;

    private static Scene scene(NearTies family) throws Exception {
        return Scenes.parse(family.scene(7, 300, WIDTH, HEIGHT)).scene();
    }

    private static int[] render(Tracer tracer, Sampling sampling, int threads, Region region) {
        Image image = new Image(region.width(), region.height());
        new Renderer(tracer, sampling, threads, region, image).render();
        return IntStream.range(0, region.width() * region.height())
                .map(i -> image.rgb(i % region.width(), i / region.width())).toArray();
    }

    private static void assertSame(int[] expected, int[] actual, String what) {
        long differing = IntStream.range(0, expected.length).filter(i -> expected[i] != actual[i]).count();
        assertEquals(0, differing, what + ": pixels that differ");
    }

    @ParameterizedTest(name = "threads: {0}")
    @EnumSource
    void threads(NearTies family) throws Exception {
        Scene scene = scene(family);
        Region whole = Region.whole(WIDTH, HEIGHT);
        int[] one = render(Tracer.compile(scene), Sampling.CENTRES, 1, whole);
        for (int threads : new int[] {2, 4, 7}) {
            assertSame(one, render(Tracer.compile(scene), Sampling.CENTRES, threads, whole), threads + " threads");
        }
    }

    @ParameterizedTest(name = "what was rendered before: {0}")
    @EnumSource
    void repeats(NearTies family) throws Exception {
        Tracer tracer = Tracer.compile(scene(family));
        Region whole = Region.whole(WIDTH, HEIGHT);
        int[] first = render(tracer, Sampling.CENTRES, 2, whole);
        for (int repeat = 1; repeat < 4; repeat++) {
            assertSame(first, render(tracer, Sampling.CENTRES, 2, whole), "frame " + repeat);
        }
    }

    @ParameterizedTest(name = "what else is rendered: {0}")
    @EnumSource
    void regions(NearTies family) throws Exception {
        Tracer tracer = Tracer.compile(scene(family));
        for (Sampling sampling : new Sampling[] {Sampling.CENTRES, new Sampling.Within(1 / 64.0)}) {
            int[] whole = render(tracer, sampling, 2, Region.whole(WIDTH, HEIGHT));
            Region region = new Region(33, 21, 71, 57);
            int[] part = render(tracer, sampling, 2, region);
            assertSame(IntStream.range(0, part.length).map(i -> whole[(region.y() + i / region.width()) * WIDTH
                    + region.x() + i % region.width()]).toArray(), part, sampling.toString());
        }
    }
}
