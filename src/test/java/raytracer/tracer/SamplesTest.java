package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.parser.Scenes;
import raytracer.scene.Scene;
import raytracer.tracer.rays.Samples;

/** Samples that are traced together. */
class SamplesTest {

    private static final int SIDE = 16;
    private static final int WIDTH = 96;
    private static final int HEIGHT = 64;

    private static void addTile(Samples samples, int left, int top) {
        for (int i = 0; i < SIDE * SIDE; i++) {
            samples.add(left + i % SIDE + .5, top + i / SIDE + .5);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"island", "final", "kaleidoscope", "lights"})
    @DisplayName("get the colours that each gets alone")
    void doNotDependOnOneAnother(String name) throws Exception {
        Scene scene = Scenes.parse(Files.readString(Path.of("scenes", name + ".scene"))).scene().withSize(WIDTH, HEIGHT);
        TileTracer tracer = Tracer.compile(scene).newTileTracer();
        Samples together = new Samples(), alone = new Samples();
        for (int top = 0; top < HEIGHT; top += SIDE) {
            for (int left = 0; left < WIDTH; left += SIDE) {
                together.clear();
                addTile(together, left, top);
                tracer.trace(together);
                for (int i = 0; i < together.count(); i++) {
                    alone.clear();
                    alone.add(together.x[i], together.y[i]);
                    tracer.trace(alone);
                    String where = "sample at " + together.x[i] + " " + together.y[i];
                    assertEquals(alone.red[0], together.red[i], "red of " + where);
                    assertEquals(alone.green[0], together.green[i], "green of " + where);
                    assertEquals(alone.blue[0], together.blue[i], "blue of " + where);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"final", "sunflower", "planet", "star", "inside"})
    @DisplayName("at the centres of a rectangle's pixels get the colours that they get as points like any")
    void areTheSameAsCentres(String name) throws Exception {
        Scene scene = Scenes.parse(Files.readString(Path.of("scenes", name + ".scene"))).scene().withSize(WIDTH, HEIGHT);
        TileTracer tracer = Tracer.compile(scene).newTileTracer();
        Samples centres = new Samples(), points = new Samples();
        for (int top = 0; top < HEIGHT; top += 13) {
            for (int left = 0; left < WIDTH; left += SIDE) {
                int rows = Math.min(13, HEIGHT - top);
                points.clear();
                for (int i = 0; i < SIDE * rows; i++) {
                    points.add(left + i % SIDE + .5, top + i / SIDE + .5);
                }
                tracer.trace(points);
                tracer.traceCentres(left, top, SIDE, rows, centres);
                assertEquals(points.count(), centres.count());
                assertSame(points.x, centres.x, points.count());
                assertSame(points.y, centres.y, points.count());
                assertSame(points.red, centres.red, points.count());
                assertSame(points.green, centres.green, points.count());
                assertSame(points.blue, centres.blue, points.count());
            }
        }
    }

    private static void assertSame(double[] expected, double[] actual, int count) {
        assertArrayEquals(Arrays.copyOf(expected, count), Arrays.copyOf(actual, count));
    }
}
