package raytracer.speed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracer.chart.Figure;
import raytracer.chart.Origin;
import raytracer.chart.Panel;
import raytracer.image.Canvas;
import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/**
 * Our samples and POV-Ray's antialiasing of one scene on one chart, in turns: {@code mvn test -Dtest=SamplesChart}, if
 * {@code povray} is installed. Each is compared with what it comes to itself with very many samples, so that it does
 * not matter that highlights differ; times are of tracing alone, ours after a first round that does not count.
 */
class SamplesChart {

    private static final Path SITE = Path.of("src", "site");
    private static final int THREADS = Runtime.getRuntime().availableProcessors();
    private static final int ROUNDS = 3;

    private static final Pattern TRACE_TIME = Pattern.compile("Trace Time:.*\\(([0-9.]+) seconds\\)");
    private static final String[] CONVERGED = {"+A0.0", "+AM1", "+R10", "-J"};

    @TempDir
    private Path folder;

    private Scene scene;
    private Tracer tracer;

    /** A way to render; what it takes by round, and its error. */
    private static final class Measured {
        final List<Double> millis = new ArrayList<>();
        double error;

        double median() {
            return millis.stream().sorted().toList().get(millis.size() / 2);
        }
    }

    @Test
    void ofTheShowPiece() throws Exception {
        scene = Scenes.parse(Files.readString(Path.of("scenes", "final.scene"))).scene();
        tracer = Tracer.compile(scene);
        Files.writeString(folder.resolve("scene.pov"), PovScene.of(scene));
        Map<String, Sampling> ours = new LinkedHashMap<>();
        for (int n : new int[] {1, 2, 3, 4, 6, 8}) {
            ours.put("--samples " + n, new Sampling.Grid(n));
        }
        for (int n : new int[] {64, 128, 255, 512, 1024}) {
            ours.put("--samples auto:1/" + n, new Sampling.Within(1.0 / n));
        }
        List<String> pov = List.of("-A", "+A0.3", "+A0.1", "+A0.03", "+AM2 +A0.3 +R2", "+AM2 +A0.1 +R3", "+AM2 +A0.05 +R4");
        Canvas half = render(new Sampling.Lattice(256, 1)), other = render(new Sampling.Lattice(256, 2));
        Canvas reference = Canvas.mean(half, other);
        double[] povReference = pov(new Measured(), CONVERGED);
        Map<String, Measured> all = new LinkedHashMap<>();
        for (int round = -1; round < ROUNDS; round++) {
            for (String setting : ours.keySet()) {
                long start = System.nanoTime();
                Canvas canvas = render(ours.get(setting));
                double millis = (System.nanoTime() - start) / 1e6;
                Measured m = all.computeIfAbsent(setting, s -> new Measured());
                m.error = canvas.rmse(reference);
                if (round >= 0) {
                    m.millis.add(millis);
                }
            }
            for (String setting : round < 0 ? List.<String>of() : pov) {
                Measured m = all.computeIfAbsent("POV-Ray " + setting, s -> new Measured());
                m.error = rmse(pov(m, setting.split(" ")), povReference);
            }
        }
        write(all, half.rmse(other) / 2);
    }

    private void write(Map<String, Measured> all, double floor) throws Exception {
        List<String> csv = new ArrayList<>(List.of("# " + Origin.text(), "setting,median ms,rmse"));
        Panel panel = new Panel("", "milliseconds of tracing, " + THREADS + " threads", "RMSE of a range of [0, 1]",
                floor);
        panel.limit(Sampling.Within.INVISIBLE);
        for (Map.Entry<String, Measured> e : all.entrySet()) {
            Measured m = e.getValue();
            csv.add(String.format(Locale.ROOT, "%s,%.1f,%.6f", e.getKey(), m.median(), m.error));
            panel.point(e.getKey().replace("--samples ", ""), e.getKey().startsWith("POV") ? 0
                    : e.getKey().contains("auto") ? 4 : 2, m.median(), m.millis.stream().min(Double::compare).orElseThrow(),
                    m.millis.stream().max(Double::compare).orElseThrow(), m.error);
        }
        csv.forEach(System.out::println);
        Files.write(SITE.resolve("samples.csv"), csv, StandardCharsets.UTF_8);
        Figure figure = new Figure("Smooth edges by many ways: scenes/final.scene, "
                + scene.width() + "x" + scene.height(), "Each against what it comes to itself. " + Origin.text(), 1, 720, 500);
        figure.add(panel);
        figure.explain(2, "n x n samples");
        figure.explain(4, "as many as an error takes");
        figure.explain(0, "POV-Ray");
        figure.explainBars("fastest and slowest");
        figure.explainLimit("RMSE of 1/255");
        figure.explainBand("our reference's own error");
        figure.explainFront("no setting measured is faster and as accurate");
        Files.writeString(SITE.resolve("samples.svg"), figure.svg());
    }

    private Canvas render(Sampling sampling) {
        Canvas canvas = new Canvas(scene.width(), scene.height());
        new Renderer(tracer, sampling, THREADS, Region.whole(scene.width(), scene.height()), canvas).render();
        return canvas;
    }

    /** Lets POV-Ray render with 16 bits a component and without gamma; returns the components of its picture. */
    private double[] pov(Measured time, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("povray", "+Iscene.pov", "+Oout.png", "+W" + scene.width(),
                "+H" + scene.height(), "-D", "+WT" + THREADS, "+FN16", "File_Gamma=1.0"));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), out);
        Matcher traced = TRACE_TIME.matcher(out);
        while (traced.find()) {
            time.millis.add(1e3 * Double.parseDouble(traced.group(1)));
        }
        Raster raster = ImageIO.read(folder.resolve("out.png").toFile()).getRaster();
        double[] values = raster.getPixels(0, 0, raster.getWidth(), raster.getHeight(), (double[]) null);
        for (int i = 0; i < values.length; i++) {
            values[i] /= 65535;
        }
        return values;
    }

    private static double rmse(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return Math.sqrt(sum / a.length);
    }
}
