package raytracer.speed;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import raytracer.chart.Origin;
import raytracer.image.Canvas;
import raytracer.image.Canvas;
import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/**
 * Whether {@code --samples auto} keeps its word on scenes of thin things and on our own at half their size: {@code mvn test
 * -Dtest=ThinThings}, three minutes. Errors are against 2048 samples a pixel of another pattern, whose own error counts.
 */
class ThinThings {

    private static final int THREADS = Runtime.getRuntime().availableProcessors();
    private static final int[] AIMS = {64, 255, 1000};
    private static final int[] GRIDS = {1, 2, 3, 4, 6, 8};
    private static final int REFERENCE = 2048;

    /** What bytes round, and what the reference is off. */
    private static final double SLACK = 0.5 / 255 + 1e-4;

    private final List<String> csv = new ArrayList<>();

    @Test
    void keepToTheirErrors() throws Exception {
        csv.add("# " + Origin.text());
        csv.add("scene,aim,error by aim,samples a pixel,ms,coarsest grid as good,ms of that");
        for (Map.Entry<String, String> thin : ThinScenes.all().entrySet()) {
            measure(thin.getKey(), Scenes.parse(thin.getValue()).scene());
        }
        for (String own : List.of("final", "first", "island", "lights", "materials", "planet", "star", "sunflower")) {
            Scene scene = Scenes.parse(Files.readString(Path.of("scenes", own + ".scene"))).scene();
            measure(own, scene.withSize(scene.width() / 2, scene.height() / 2));
        }
        csv.forEach(System.out::println);
        Files.write(Path.of("src", "site", "thin.csv"), csv, StandardCharsets.UTF_8);
    }

    private void measure(String name, Scene scene) {
        Tracer tracer = Tracer.compile(scene);
        Canvas reference = render(scene, tracer, new Sampling.Lattice(REFERENCE, 1), new RayCounts[1]);
        for (int aim : AIMS) {
            RayCounts[] counts = new RayCounts[1];
            Sampling auto = new Sampling.Within(1.0 / aim);
            double error = render(scene, tracer, auto, counts).rmse(reference);
            int grid = 0;
            while (grid < GRIDS.length
                    && render(scene, tracer, new Sampling.Grid(GRIDS[grid]), new RayCounts[1]).rmse(reference) > 1.0 / aim) {
                grid++;
            }
            csv.add(String.format(Locale.ROOT, "\"%s\",1/%d,%.2f,%.1f,%.0f,%s", name, aim, error * aim,
                    (double) counts[0].primary() / scene.width() / scene.height(), millis(scene, tracer, auto),
                    grid == GRIDS.length ? "none," : String.format(Locale.ROOT, "%dx%d,%.0f", GRIDS[grid], GRIDS[grid],
                            millis(scene, tracer, new Sampling.Grid(GRIDS[grid])))));
            assertTrue(error <= 1.0 / aim + SLACK, csv.get(csv.size() - 1));
        }
    }

    /** The best of three, or of as many as half a second takes: what little time compiles is no part of it. */
    private static double millis(Scene scene, Tracer tracer, Sampling sampling) {
        double best = Double.POSITIVE_INFINITY;
        long first = System.nanoTime();
        for (int round = 0; round < 3 || System.nanoTime() - first < 5e8; round++) {
            long start = System.nanoTime();
            render(scene, tracer, sampling, new RayCounts[1]);
            best = Math.min(best, (System.nanoTime() - start) / 1e6);
        }
        return best;
    }

    private static Canvas render(Scene scene, Tracer tracer, Sampling sampling, RayCounts[] counts) {
        Canvas canvas = new Canvas(scene.width(), scene.height());
        counts[0] = new Renderer(tracer, sampling, THREADS, Region.whole(scene.width(), scene.height()), canvas).render();
        return canvas;
    }
}
