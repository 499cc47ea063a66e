package raytracer.speed;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracer.chart.Figure;
import raytracer.chart.Origin;
import raytracer.chart.Panel;

/**
 * Measures the program's speed and draws how it scales. Not a test that a plain {@code mvn test} runs, since it takes
 * minutes: {@code mvn test -Dtest=SpeedCharts}. Figures count only if the picture is the right one.
 */
class SpeedCharts {

    private static final Path SITE = Path.of("src", "site");

    @TempDir
    private Path folder;

    /** Six scenes, each step cold (a new process) and warm, on all cores; by kind of ray on one thread. */
    @Test
    void sixScenes() throws Exception {
        List<String> csv = new ArrayList<>();
        csv.add("# " + Origin.text());
        csv.add("scene,when,parse ms,build ms,trace ms,write ms,whole process ms");
        List<String> rays = new ArrayList<>();
        rays.add("scene,primary Mrays/s,shadow Mrays/s,reflected Mrays/s (and their shadows)");
        for (Subject subject : Subject.six()) {
            Measurement m = new Measurement(subject, folder);
            assertTrue(subject.isRight(m.picture()), subject.name() + ": the picture is not the exact one");
            csv.add(m.cold());
            csv.add(m.warm());
            rays.add(m.raysByKind());
        }
        csv.addAll(rays);
        csv.forEach(System.out::println);
        Files.write(SITE.resolve("speed.csv"), csv);
    }

    /** The mountains at 10^3 to 10^6.5 triangles: building and tracing, warm, one thread. */
    @Test
    void scaling() throws Exception {
        List<double[]> build = new ArrayList<>(), trace = new ArrayList<>();
        List<String> csv = new ArrayList<>(List.of("# " + Origin.text(), "triangles,build ms,trace ms"));
        for (Subject subject : Subject.mountains()) {
            Measurement m = new Measurement(subject, folder);
            assertTrue(subject.isRight(m.picture()), subject.name() + ": the picture is not the exact one");
            double n = m.triangles();
            double[] times = m.buildAndTraceOnOneThread();
            build.add(new double[] {n, times[0]});
            trace.add(new double[] {n, times[1]});
            csv.add(String.format(Locale.ROOT, "%.0f,%.2f,%.2f", n, times[0], times[1]));
        }
        csv.forEach(System.out::println);
        Files.write(SITE.resolve("scaling.csv"), csv);
        draw(build, trace);
    }

    private static void draw(List<double[]> build, List<double[]> trace) throws IOException, InterruptedException {
        Panel panel = new Panel("Mountains of n triangles, 640x480, one thread; every picture is the exact one",
                "triangles", "ms", 0, "");
        panel.withoutFront();
        for (double[] p : build) {
            panel.point(p == build.get(build.size() - 1) ? "build the tree" : "", 2, p[0], p[0], p[0], p[1]);
        }
        for (double[] p : trace) {
            panel.point(p == trace.get(trace.size() - 1) ? "trace" : "", 0, p[0], p[0], p[0], p[1]);
        }
        panel.curve("", build);
        panel.curve("", trace);
        Figure figure = new Figure("Time against triangles", Origin.text(), 1, 860, 400);
        figure.add(panel);
        figure.write(SITE.resolve("scaling.svg"));
    }

    static String read(Path file) throws IOException {
        return Files.readString(file, StandardCharsets.UTF_8);
    }
}
