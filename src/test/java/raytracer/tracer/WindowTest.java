package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.parser.Scenes;
import raytracer.scene.Vector;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.rays.Window;

@DisplayName("A window in the picture")
class WindowTest {

    /** Of numbers up to some hundred, by a dozen roundings. */
    private static final double ROUNDING = 1e-12;

    @ParameterizedTest
    @CsvSource({"0 0 5 0 0 0 0 1 0 45, 0, 20, 0, 20", "1 2 3 -4 5 .5 .1 1 .3 100, 20, 40, 40, 50",
        "-1e6 3 2 -1e6 0 0 0 1 0 179, 50, 51, 30, 31", "0 0 0 -1 -1 -1 0 0 1 5, 59, 60, 0, 50"})
    @DisplayName("is as large as the vectors to its corners say, which are of length 1 and more")
    void holdsWhatItMust(String camera, double fromX, double toX, double fromY, double toY) throws Exception {
        Pinhole pinhole = new Pinhole(Scenes.parse("size 60 50\ncamera " + camera).scene());
        Vector backward = Scenes.parse("size 60 50\ncamera " + camera).scene().camera().backward();
        Rays rays = new Rays();
        Samples corners = Samples.ofColour();
        for (int i = 0; i < 4; i++) {
            SamplesTest.add(corners, i % 2 == 0 ? fromX : toX, i / 2 == 0 ? fromY : toY);
        }
        rays.start(pinhole.aiming(rays), null, corners, 0, 4);
        Window window = pinhole.window(fromX, toX, fromY, toY);
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY, greatest = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < 4; i++) {
                Vector d = new Vector(rays.dx[i], rays.dy[i], rays.dz[i]);
                double length = -1 / d.dot(backward);
                assertTrue(length >= 1 - ROUNDING);
                least = Math.min(least, d.along(axis) * length);
                greatest = Math.max(greatest, d.along(axis) * length);
            }
            assertEquals(least, window.min()[axis], ROUNDING * Math.max(1, Math.abs(least)));
            assertEquals(greatest, window.max()[axis], ROUNDING * Math.max(1, Math.abs(greatest)));
        }
    }
}
