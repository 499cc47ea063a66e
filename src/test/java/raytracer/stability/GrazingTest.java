package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracer.exact.ExactRenderer;
import raytracer.image.Image;
import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Colour;
import raytracer.scene.Scene;
import raytracer.tracer.Explainer;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;
import raytracer.tracer.rays.Samples;

/** {@code mvn test -Dtest=GrazingTest -Dseeds=1000} tries that many scenes of each floor. */
class GrazingTest {

    private static final int SEEDS = Integer.getInteger("seeds", 30);

    /** Of the row that grazes. */
    private static final int COLUMNS = 401;

    private static int[] render(Scene scene, int threads, Region region) {
        Image image = new Image(region.width(), region.height());
        new Renderer(Tracer.compile(scene), Sampling.CENTRES, threads, region, image).render();
        return IntStream.range(0, region.width() * region.height())
                .map(i -> image.rgb(i % region.width(), i / region.width())).toArray();
    }

    private static int[] render(Scene scene) {
        return render(scene, 1, Region.whole(scene.width(), scene.height()));
    }

    private static long wrongInRow(Scene scene, int[] picture, IntBinaryOperator judge) {
        return IntStream.range(0, scene.width()).filter(x -> picture[x] != judge.applyAsInt(x, 0)).count();
    }

    @ParameterizedTest(name = "{0}: the row is right, down to 1e-10 above it")
    @EnumSource
    void rowIsRight(GrazedFloors floor) throws Exception {
        for (int seed = 0; seed < SEEDS; seed++) {
            // Mirrored rays do not graze what they return to as exactly: accuracy.md has figures.
            int depth = seed % 6 < 3 ? 1 + seed % 3 : 1;
            Scene scene = Scenes.parse(floor.scene(seed, Math.pow(10, -5 - seed % 6), COLUMNS, 1, depth)).scene();
            assertEquals(0, wrongInRow(scene, render(scene), new ExactRenderer(scene)::pixel), floor + " " + seed);
        }
    }

    @ParameterizedTest(name = "{0}: below that, no scene is worse than in plain doubles")
    @EnumSource
    void noWorseThanPlainDoubles(GrazedFloors floor) throws Exception {
        for (int seed = 0; seed < SEEDS; seed++) {
            double height = Math.pow(10, -11 - seed % 6);
            Scene scene = Scenes.parse(floor.scene(seed, height, COLUMNS, 1, 1)).scene();
            ExactRenderer exact = new ExactRenderer(scene);
            PlainDoubles plain = new PlainDoubles(scene);
            int[] plainly = IntStream.range(0, COLUMNS).map(x -> plain.pixel(x, 0)).toArray();
            long ours = wrongInRow(scene, render(scene), exact::pixel), theirs = wrongInRow(scene, plainly, exact::pixel);
            assertEquals(Math.min(ours, theirs), ours, floor + " " + seed);
        }
    }

    @ParameterizedTest(name = "{0}: a pixel has one value, whatever is traced beside it")
    @EnumSource
    void onePixelOneValue(GrazedFloors floor) throws Exception {
        for (int seed = 0; seed < SEEDS; seed++) {
            double height = Math.pow(10, -5 - 11 * new Random(seed).nextDouble());
            Scene scene = Scenes.parse(floor.scene(seed, height, 24, 17, 1 + seed % 3)).scene();
            int[] whole = render(scene);
            String name = floor + " " + seed;
            assertArrayEquals(whole, render(scene, 2 + seed % 6, Region.whole(24, 17)), name + ": threads");
            assertArrayEquals(IntStream.range(8 * 24, 9 * 24).map(i -> whole[i]).toArray(),
                    render(scene, 1, new Region(0, 8, 24, 1)), name + ": the row alone");
            assertArrayEquals(whole, oneByOne(scene), name + ": pixels one by one");
            assertArrayEquals(whole, shuffled(scene), name + ": pixels from all over together");
            assertArrayEquals(whole, explained(scene), name + ": pixels as they are explained");
        }
    }

    private static int[] oneByOne(Scene scene) {
        TileTracer tracer = Tracer.compile(scene).newTileTracer();
        Samples samples = new Samples();
        Image image = new Image(scene.width(), scene.height());
        for (int i = 0; i < scene.width() * scene.height(); i++) {
            int x = i % scene.width(), y = i / scene.width();
            tracer.traceCentres(x, y, 1, 1, samples);
            image.setPixels(x, y, 1, 1, samples.red, samples.green, samples.blue);
        }
        return pixels(image, scene);
    }

    /** All rays of the picture are walks: for a beam they are too unlike. */
    private static int[] shuffled(Scene scene) {
        List<Integer> order = new ArrayList<>(IntStream.range(0, scene.width() * scene.height()).boxed().toList());
        Collections.shuffle(order, new Random(1));
        TileTracer tracer = Tracer.compile(scene).newTileTracer();
        Samples samples = new Samples();
        Image image = new Image(scene.width(), scene.height());
        for (int from = 0; from < order.size(); from += samples.count()) {
            samples.clear();
            for (int pixel : order.subList(from, Math.min(from + Samples.CAPACITY, order.size()))) {
                samples.add(pixel % scene.width() + .5, pixel / scene.width() + .5);
            }
            tracer.trace(samples);
            for (int i = 0; i < samples.count(); i++) {
                image.setPixels((int) samples.x[i], (int) samples.y[i], 1, 1, new double[] {samples.red[i]},
                        new double[] {samples.green[i]}, new double[] {samples.blue[i]});
            }
        }
        return pixels(image, scene);
    }

    private static int[] explained(Scene scene) {
        Explainer explainer = Tracer.compile(scene).newExplainer();
        Image image = new Image(scene.width(), scene.height());
        for (int i = 0; i < scene.width() * scene.height(); i++) {
            Colour c = explainer.explain(i % scene.width(), i / scene.width()).colour();
            image.setPixels(i % scene.width(), i / scene.width(), 1, 1, new double[] {c.red()}, new double[] {c.green()},
                    new double[] {c.blue()});
        }
        return pixels(image, scene);
    }

    private static int[] pixels(Image image, Scene scene) {
        return IntStream.range(0, scene.width() * scene.height())
                .map(i -> image.rgb(i % scene.width(), i / scene.width())).toArray();
    }
}
