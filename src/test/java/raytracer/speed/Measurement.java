package raytracer.speed;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import raytracer.image.Image;
import raytracer.image.PngFile;
import raytracer.parser.SceneParser;
import raytracer.render.Rendering;
import raytracer.scene.Scene;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/** Times the steps from one scene's text to its picture's file. */
final class Measurement {

    private static final int CORES = Runtime.getRuntime().availableProcessors();
    private static final int COLD_ROUNDS = 5;

    /** Rounds before the ones that count, so that HotSpot has compiled what it is going to. */
    private static final int WARM_UP = 8;
    private static final int ROUNDS = 7;

    private final Subject subject;
    private final byte[] text;
    private final Scene scene;
    private final Path sceneFile;
    private final Path picture;
    private final Path stats;

    Measurement(Subject subject, Path folder) throws Exception {
        this.subject = subject;
        text = subject.text().getBytes(StandardCharsets.UTF_8);
        scene = parse();
        sceneFile = Files.write(folder.resolve(subject.name() + ".scene"), text);
        picture = folder.resolve(subject.name() + ".png");
        stats = folder.resolve("stats.json");
    }

    private Scene parse() throws Exception {
        return SceneParser.parse(subject.name(), new ByteArrayInputStream(text)).scene();
    }

    int triangles() {
        return scene.mesh().triangles();
    }

    Image picture() {
        Image image = new Image(scene.width(), scene.height());
        Rendering.of(Tracer.compile(scene), CORES, image).render();
        return image;
    }

    /** Medians of whole processes, each with a Java of its own. */
    String cold() throws IOException, InterruptedException {
        double[][] times = new double[5][COLD_ROUNDS];
        for (int round = 0; round < COLD_ROUNDS; round++) {
            long start = System.nanoTime();
            Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-cp", "target/classes", "raytracer.cli.Main", "--quiet", "-o", picture.toString(),
                    "--stats", stats.toString(), sceneFile.toString()).inheritIO().start();
            if (process.waitFor() != 0) {
                throw new IllegalStateException("the program failed on " + subject.name());
            }
            times[4][round] = (System.nanoTime() - start) / 1e6;
            String json = SpeedCharts.read(stats);
            times[0][round] = figure(json, "parseMillis");
            times[1][round] = figure(json, "buildMillis");
            times[2][round] = figure(json, "renderMillis");
            times[3][round] = figure(json, "writeMillis");
        }
        return row("cold", median(times[0]), median(times[1]), median(times[2]), median(times[3]), median(times[4]));
    }

    /** Medians within one process that has done it all several times. */
    String warm() throws Exception {
        Image image = new Image(scene.width(), scene.height());
        double[][] times = new double[4][ROUNDS];
        for (int round = -WARM_UP; round < ROUNDS; round++) {
            long start = System.nanoTime();
            Scene parsed = parse();
            long parsedAt = System.nanoTime();
            Tracer tracer = Tracer.compile(parsed);
            long builtAt = System.nanoTime();
            Rendering.of(tracer, CORES, image).render();
            long tracedAt = System.nanoTime();
            try (var out = java.nio.file.Files.newOutputStream(picture)) {
                PngFile.write(image.toBufferedImage(), out);
            }
            long writtenAt = System.nanoTime();
            if (round >= 0) {
                times[0][round] = (parsedAt - start) / 1e6;
                times[1][round] = (builtAt - parsedAt) / 1e6;
                times[2][round] = (tracedAt - builtAt) / 1e6;
                times[3][round] = (writtenAt - tracedAt) / 1e6;
            }
        }
        return row("warm", median(times[0]), median(times[1]), median(times[2]), median(times[3]), Double.NaN);
    }

    /**
     * Millions of rays a second and thread: the eye's from the scene without lights and mirrors; then what lights add,
     * and what mirrors add to that.
     */
    String raysByKind() {
        Scene lit = scene.withMaxDepth(1);
        Scene dark = new Scene(scene.width(), scene.height(), scene.camera(), 1, true, List.of(), scene.shapes(), scene.mesh(), "");
        RayCounts[] counts = new RayCounts[3];
        double[] ms = traceInTurns(List.of(dark, lit, scene), counts);
        long reflected = counts[2].reflection();
        return String.format(Locale.ROOT, "%s,%.2f,%.2f,%s", subject.name(), counts[0].primary() / ms[0] / 1e3,
                counts[1].shadow() / Math.max(ms[1] - ms[0], 1e-9) / 1e3, reflected == 0 ? "-"
                        : String.format(Locale.ROOT, "%.2f", reflected / Math.max(ms[2] - ms[1], 1e-9) / 1e3));
    }

    double[] buildAndTraceOnOneThread() {
        double[] build = new double[ROUNDS];
        for (int round = 0; round < ROUNDS; round++) {
            long start = System.nanoTime();
            Tracer.compile(scene);
            build[round] = (System.nanoTime() - start) / 1e6;
        }
        return new double[] {median(build), traceInTurns(List.of(scene), new RayCounts[1])[0]};
    }

    private static double[] traceInTurns(List<Scene> scenes, RayCounts[] counts) {
        List<Tracer> tracers = new ArrayList<>();
        scenes.forEach(s -> tracers.add(Tracer.compile(s)));
        Image image = new Image(scenes.get(0).width(), scenes.get(0).height());
        double[][] times = new double[scenes.size()][ROUNDS];
        for (int round = -WARM_UP; round < ROUNDS; round++) {
            for (int k = 0; k < scenes.size(); k++) {
                long start = System.nanoTime();
                counts[k] = Rendering.of(tracers.get(k), 1, image).render();
                if (round >= 0) {
                    times[k][round] = (System.nanoTime() - start) / 1e6;
                }
            }
        }
        return Arrays.stream(times).mapToDouble(Measurement::median).toArray();
    }

    private String row(String when, double parse, double build, double trace, double write, double whole) {
        return String.format(Locale.ROOT, "%s,%s,%.1f,%.1f,%.1f,%.1f,%s", subject.name(), when, parse, build, trace, write,
                Double.isNaN(whole) ? "-" : String.format(Locale.ROOT, "%.0f", whole));
    }

    private static double figure(String json, String name) {
        Matcher m = Pattern.compile("\"" + name + "\": \\[?([0-9.]+)").matcher(json);
        if (!m.find()) {
            throw new IllegalStateException("no " + name + " in " + json);
        }
        return Double.parseDouble(m.group(1));
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
