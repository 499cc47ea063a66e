package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracer.parser.Scenes;
import raytracer.scene.Vector;
import raytracer.stability.NearTies;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.rays.Samples;

/** Of surfaces that rounding cannot tell apart. */
class TiesTest {

    private static final int WIDTH = 40;
    private static final int HEIGHT = 30;
    private static final double[] OFFSETS = {0, 1, 300, 1e4};
    private static final int SEEDS = Integer.getInteger("seeds", 5);

    /** A scene to be searched in ways that a test chooses. */
    private static final class Searched {
        private final Tracer compiled;

        Searched(String text) throws Exception {
            compiled = Tracer.compile(Scenes.parse(text).scene());
        }

        /** All pixels' red, in tiles whose beams are as narrow as can be for so many rays. */
        double[] tiled(int side) {
            double[] red = new double[WIDTH * HEIGHT];
            TileTracer tracer = compiled.newTileTracer();
            Samples samples = new Samples();
            for (int top = 0; top < HEIGHT; top += side) {
                for (int left = 0; left < WIDTH; left += side) {
                    int columns = Math.min(side, WIDTH - left), rows = Math.min(side, HEIGHT - top);
                    tracer.traceCentres(left, top, columns, rows, samples);
                    for (int i = 0; i < columns * rows; i++) {
                        red[(top + i / columns) * WIDTH + left + i % columns] = samples.red[i];
                    }
                }
            }
            return red;
        }

        /** All pixels' red, of rays from all over the picture together: for a beam they are too wide. */
        double[] scattered() {
            double[] red = new double[WIDTH * HEIGHT];
            List<Integer> pixels = new ArrayList<>(IntStream.range(0, red.length).boxed().toList());
            Collections.shuffle(pixels, new Random(1));
            TileTracer tracer = compiled.newTileTracer();
            Samples samples = new Samples();
            for (int from = 0; from < red.length; from += Samples.CAPACITY) {
                List<Integer> some = pixels.subList(from, Math.min(from + Samples.CAPACITY, red.length));
                samples.clear();
                some.forEach(p -> samples.add(p % WIDTH + .5, p / WIDTH + .5));
                tracer.trace(samples);
                for (int i = 0; i < some.size(); i++) {
                    red[some.get(i)] = samples.red[i];
                }
            }
            return red;
        }
    }

    @ParameterizedTest(name = "{0}: a ray sees the same by beam and by its own walk")
    @EnumSource
    void everySearchFindsTheSame(NearTies family) throws Exception {
        for (int seed = 0; seed < SEEDS; seed++) {
            for (double offset : OFFSETS) {
                String text = family.scene(seed, offset, WIDTH, HEIGHT);
                Searched scene = new Searched(text);
                double[] tiled = scene.tiled(Batch.SIDE);
                String name = family + " " + seed + " at " + offset;
                assertArrayEquals(tiled, scene.tiled(1), name + ": one ray a tile");
                assertArrayEquals(tiled, scene.scattered(), name + ": walks");
                assertTrue(Arrays.stream(tiled).distinct().count() > 20, name + " is all alike");
            }
        }
    }

    @Test
    @DisplayName("the first declared that is as near as the surest is seen, whatever lies between")
    void theRule() throws Exception {
        // At a distance of 1 errors are about 2e-15. The third is clearly nearer than the first; the second ties with both.
        double first = 1 + 6e-15, second = 1 + 3e-15, third = 1;
        double[][] orders = {{first, second, third}, {second, first, third}, {third, second, first},
            {first, third, second}, {second, third, first}, {third, first, second}};
        for (double[] order : orders) {
            StringBuilder shapes = new StringBuilder();
            for (double distance : order) {
                shapes.append("plane 0 0 ").append(-distance).append(" 0 0 1\n");
            }
            Probe.Meeting m = new Probe(shapes.toString()).shoot(new Vector(0, 0, 0), new Vector(0, 0, -1));
            double seen = order[m.shape()];
            double wanted = Arrays.stream(order).filter(d -> d != first).findFirst().orElseThrow();
            assertEquals(wanted, seen, Arrays.toString(order));
        }
    }

    @Test
    @DisplayName("the first of ten thousand identical ones is seen")
    void identical() throws Exception {
        String triangles = "tri 0 1 2\n".repeat(10_000), spheres = "sphere 0 0 -2 .5\n".repeat(10_000);
        for (String shapes : new String[] {"sphere 5 0 0 1\n" + spheres,
            "maxverts 3\nvertex -1 -1 -2\nvertex 1 -1 -2\nvertex 0 1 -2\nplane 0 0 9 0 0 1\n" + triangles}) {
            Probe probe = new Probe(shapes);
            for (int i = 0; i < 1000; i++) {
                assertEquals(1, probe.shoot(new Vector(0, 0, 0), new Vector(0, 0, -1)).shape());
            }
        }
    }
}
