package raytracer.speed;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import raytracer.chart.Origin;
import raytracer.image.Canvas;
import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/**
 * The time that adaptive samples take for the error of 8 x 8 uniform ones, both in turns:
 * {@code mvn test -Dtest=SamplesAtEqualError}, in about seven minutes. Errors are against many samples in another pattern.
 */
class SamplesAtEqualError {

    private static final int THREADS = Runtime.getRuntime().availableProcessors();
    private static final int ROUNDS = 3;
    private static final Sampling UNIFORM = new Sampling.Grid(8);

    private Scene scene;
    private Tracer tracer;

    @Test
    void ofMeshesAndTheShowPiece() throws Exception {
        List<String> csv = new ArrayList<>(List.of("# " + Origin.text(),
                "scene,the reference's own error,rmse 8x8,median ms 8x8,aim,rmse auto,median ms auto,part of the time"));
        csv.add(compare("star", 1280, 960));
        csv.add(compare("island", 1920, 1200));
        csv.add(compare("final", 640, 480));
        csv.forEach(System.out::println);
        Files.write(Path.of("src", "site", "equal-error.csv"), csv);
    }

    private String compare(String name, int width, int height) throws Exception {
        String text = Files.readString(Path.of("scenes", name + ".scene"));
        scene = Scenes.parse(text).scene().withSize(width, height);
        tracer = Tracer.compile(scene);
        Canvas half = render(new Sampling.Lattice(128, 1)), other = render(new Sampling.Lattice(128, 2));
        Canvas reference = Canvas.mean(half, other);
        double floor = half.rmse(other) / 2;
        double uniformError = render(UNIFORM).rmse(reference);
        // What is measured is the error and the reference's together.
        double aim = Math.sqrt(uniformError * uniformError - floor * floor);
        Sampling adaptive = new Sampling.Adaptive(aim);
        double adaptiveError = render(adaptive).rmse(reference);
        List<Double> uniformMillis = new ArrayList<>(), adaptiveMillis = new ArrayList<>();
        for (int round = 0; round < ROUNDS; round++) {
            uniformMillis.add(millis(UNIFORM));
            adaptiveMillis.add(millis(adaptive));
        }
        double uniform = median(uniformMillis), auto = median(adaptiveMillis);
        return String.format(Locale.ROOT, "%s %dx%d,%.6f,%.6f,%.1f,%.6f,%.6f,%.1f,%.3f", name, width, height, floor,
                uniformError, uniform, aim, adaptiveError, auto, auto / uniform);
    }

    private Canvas render(Sampling sampling) {
        Canvas canvas = new Canvas(scene.width(), scene.height());
        new Renderer(tracer, sampling, THREADS, Region.whole(scene.width(), scene.height()), canvas).render();
        return canvas;
    }

    private double millis(Sampling sampling) {
        long start = System.nanoTime();
        render(sampling);
        return (System.nanoTime() - start) / 1e6;
    }

    private static double median(List<Double> values) {
        return values.stream().sorted().toList().get(values.size() / 2);
    }
}
