package raytracer.chart;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Draws the charts of speed against accuracy into src/site. Not a test that a plain {@code mvn test} runs, since it
 * takes minutes: {@code mvn test -Dtest=AccuracyCharts}.
 */
class AccuracyCharts {

    private static final Path SITE = Path.of("src", "site");

    @Test
    void draw() throws Exception {
        List<String> csv = new ArrayList<>();
        String origin = origin();
        csv.add("# " + origin);
        csv.add("chart,regime,method,median ns,lower quartile,upper quartile,count,wrong,error of t 99.9 %");
        KernelCharts kernels = new KernelCharts(origin, csv);
        kernels.spheres(SITE.resolve("spheres.svg"));
        kernels.triangles(SITE.resolve("triangles.svg"));
        new LeavingChart(origin, csv).write(SITE.resolve("leaving.svg"));
        new PictureChart(origin, csv).write(SITE.resolve("pictures.svg"));
        Files.write(SITE.resolve("accuracy.csv"), csv);
    }

    /** Machine, Java, commit and date. */
    private static String origin() throws IOException, InterruptedException {
        String cpu = "unknown processor";
        Path info = Path.of("/proc/cpuinfo");
        if (Files.exists(info)) {
            cpu = Files.readAllLines(info).stream().filter(l -> l.startsWith("model name")).findFirst()
                    .map(l -> l.substring(l.indexOf(':') + 2)).orElse(cpu);
        }
        return cpu + ", " + Runtime.getRuntime().availableProcessors() + " cores; Java " + Runtime.version() + "; commit "
                + commit() + "; " + LocalDate.now();
    }

    private static String commit() throws IOException, InterruptedException {
        Process git = new ProcessBuilder("git", "describe", "--always", "--dirty").redirectErrorStream(true).start();
        String name = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        return git.waitFor() == 0 ? name : "unknown";
    }
}
