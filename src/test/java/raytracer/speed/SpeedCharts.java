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
import raytracer.chart.Origin;

/**
 * Measures the program's speed and how it scales. Not a test that a plain {@code mvn test} runs, since it takes
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
        List<String> csv = new ArrayList<>(List.of("# " + Origin.text(), "triangles,build ms,trace ms"));
        for (Subject subject : Subject.mountains()) {
            Measurement m = new Measurement(subject, folder);
            assertTrue(subject.isRight(m.picture()), subject.name() + ": the picture is not the exact one");
            double n = m.triangles();
            double[] times = m.buildAndTraceOnOneThread();
            csv.add(String.format(Locale.ROOT, "%.0f,%.2f,%.2f", n, times[0], times[1]));
        }
        csv.forEach(System.out::println);
        Files.write(SITE.resolve("scaling.csv"), csv);
    }

    static String read(Path file) throws IOException {
        return Files.readString(file, StandardCharsets.UTF_8);
    }
}
