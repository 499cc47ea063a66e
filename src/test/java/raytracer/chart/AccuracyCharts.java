package raytracer.chart;

import java.nio.file.Files;
import java.nio.file.Path;
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
        String origin = Origin.text();
        csv.add("# " + origin);
        csv.add("chart,regime,method,median ns,lower quartile,upper quartile,count,wrong,error of t 99.9 %");
        KernelCharts kernels = new KernelCharts(origin, csv);
        kernels.spheres(SITE.resolve("spheres.svg"));
        kernels.triangles(SITE.resolve("triangles.svg"));
        new LeavingChart(origin, csv).write(SITE.resolve("leaving.svg"));
        new PictureChart(origin, csv).write(SITE.resolve("pictures.svg"));
        Files.write(SITE.resolve("accuracy.csv"), csv);
    }
}
