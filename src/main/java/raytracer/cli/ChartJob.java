package raytracer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import raytracer.chart.Figure;
import raytracer.chart.Panel;
import raytracer.console.ExitStatus;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.ProgressBar;
import raytracer.console.Stopwatch;
import raytracer.console.Terminal;
import raytracer.files.Destination;
import raytracer.files.OutputFile;
import raytracer.files.Places;
import raytracer.files.Reason;
import raytracer.files.UsageException;
import raytracer.image.Canvas;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/**
 * Charts time against error for a scene: renders it under a ladder of settings, in turns, and compares each picture
 * with one of very many samples in another pattern.
 */
final class ChartJob {

    /** No visible difference: one step of 256. */
    private static final double VISIBLE = Sampling.Within.INVISIBLE;

    /** What rounding to 256 steps adds to the error of a picture, as the root of the mean square. */
    private static final double QUANTISATION = 1 / (255 * Math.sqrt(12));

    /** The part of the time for the picture to compare with, and the least and most samples of each of its halves. */
    private static final double REFERENCE_PART = 0.4;
    private static final int MIN_SAMPLES = 16;
    private static final int MAX_SAMPLES = 1024;

    /** What floats leave of the difference of two pictures that are equal. */
    private static final double MIN_FLOOR = 1e-7;

    /** The part of the time for warming up, and the most pixels of a picture for it. */
    private static final double WARM_UP_PART = 0.08;
    private static final int WARM_UP_PIXELS = 100_000;

    private static final int MAX_ROUNDS = 9;

    /** In the first round these are measured whatever time is left. */
    private static final int ALWAYS = 2;

    private final Scene original;
    private final Options options;
    private final Terminal terminal;
    private final Stopwatch elapsed = new Stopwatch();
    private final double millis;

    /** At the size that is measured: smaller than the original's if that takes too long. */
    private Tracer tracer;

    ChartJob(Scene scene, Options options, Terminal terminal) {
        original = scene;
        this.options = options;
        this.terminal = terminal;
        millis = 1e3 * options.chartSeconds();
    }

    int run() throws IOException, UsageException {
        Path svg = Reason.path(options.text(Option.CHART));
        Path csv = svg.resolveSibling(Destination.baseName(svg, ".svg") + ".csv");
        Places places = new Places();
        places.read(Reason.path(options.scenes().get(0)), "the scene");
        places.write(svg, "the chart");
        places.write(csv, "the chart's table");
        OutputFile.require(svg);
        OutputFile.require(csv);
        double perPixel = warmUp();
        // Both halves of the reference, and as much again for the settings.
        resize(Math.min(1, REFERENCE_PART * millis / (2 * MIN_SAMPLES * perPixel * original.width() * original.height())));
        double perSample = perPixel * tracer.width() * tracer.height();
        int samples = (int) Math.max(MIN_SAMPLES, Math.min(MAX_SAMPLES, REFERENCE_PART * millis / 2 / perSample));
        Canvas half = render(tracer, new Sampling.Lattice(samples, 1), "half of the reference");
        Canvas other = render(tracer, new Sampling.Lattice(samples, 2), "half of the reference");
        double floor = Math.max(MIN_FLOOR, half.rmse(other) / 2);
        List<ChartSetting> settings = ChartSetting.ladder(original.maxDepth(), perSample);
        measure(settings, Canvas.mean(half, other));
        OutputFile.write(svg, figure(settings, floor).svg());
        OutputFile.write(csv, String.join("\n", table(settings, floor)) + "\n");
        terminal.answer(sentence(settings));
        return ExitStatus.DONE;
    }

    /** Compiles the scene in a size of so many of its pixels, as a part of all. */
    private void resize(double part) {
        int width = (int) Math.max(1, original.width() * Math.sqrt(part));
        int height = (int) Math.max(1, original.height() * Math.sqrt(part));
        tracer = tracer == null ? Tracer.compile(original.withSize(width, height)) : tracer.resized(width, height);
    }

    /** Lets Java compile, with a small picture; returns the milliseconds that a sample of a pixel takes then. */
    private double warmUp() {
        resize(Math.min(1, (double) WARM_UP_PIXELS / original.width() / original.height()));
        double best = Double.POSITIVE_INFINITY;
        for (int round = 0; round < 8 && (round == 0 || elapsed.millis() < WARM_UP_PART * millis); round++) {
            Stopwatch time = new Stopwatch();
            render(tracer, Sampling.CENTRES, "warming up");
            best = Math.min(best, time.millis());
        }
        return best / tracer.width() / tracer.height();
    }

    private Canvas render(Tracer with, Sampling sampling, String what) {
        Canvas canvas = new Canvas(with.width(), with.height());
        Renderer renderer = new Renderer(with, sampling, options.threads(), Region.whole(with.width(), with.height()), canvas);
        ProgressBar.during(renderer::render, terminal.err(), options.has(Option.QUIET), renderer::progress);
        if (options.has(Option.VERBOSE)) {
            terminal.tell(String.format(Locale.ROOT, "%.0f s: %s", elapsed.millis() / 1e3, what));
        }
        return canvas;
    }

    /**
     * In turns, so that what disturbs the machine disturbs all; until the time is up. ChartSettings for which there is never
     * time are left out.
     */
    private void measure(List<ChartSetting> settings, Canvas reference) {
        // How much longer the last one took than was expected of it.
        double ratio = 1;
        for (int round = 0; round < MAX_ROUNDS; round++) {
            for (int i = 0; i < settings.size(); i++) {
                ChartSetting setting = settings.get(i);
                if (elapsed.millis() + ratio * setting.expectedMillis > millis && (round > 0 || i >= ALWAYS)) {
                    continue;
                }
                Stopwatch time = new Stopwatch();
                Canvas canvas = render(tracer.withMaxDepth(setting.maxDepth), setting.sampling, setting.arguments + ", setting "
                        + (i + 1) + " of " + settings.size() + ", round " + (round + 1));
                setting.millis.add(time.millis());
                ratio = round > 0 ? 1 : time.millis() / setting.expectedMillis;
                setting.expectedMillis = setting.median();
                setting.error = canvas.rmse(reference);
                setting.maxDifference = canvas.maxDifference(reference);
            }
            settings.removeIf(setting -> setting.millis.isEmpty());
            ratio = 1;
        }
    }

    private Figure figure(List<ChartSetting> settings, double floor) {
        Panel panel = new Panel("", "milliseconds, " + options.threads() + " threads", "RMSE of a range of [0, 1]", floor);
        panel.limit(VISIBLE);
        ChartSetting best = cheapestInvisible(settings);
        for (ChartSetting s : settings) {
            panel.point(s == best ? s.label + " (cheapest below)" : s.label, s.series, s.median(), s.quantile(0.25),
                    s.quantile(0.75), s.error);
        }
        String name = options.scenes().get(0).replaceAll("[<>&]", "");
        Figure figure = new Figure("Time against error: " + name + ", " + size(), sentence(settings).replace("<", "&lt;"), 1,
                720, 500);
        figure.add(panel);
        figure.explain(2, "n x n samples");
        figure.explain(4, "as many as an error takes");
        figure.explain(0, "fewer mirrors");
        figure.explainBars("quartiles");
        figure.explainLimit("RMSE of 1/255");
        figure.explainBand("the reference's own error");
        figure.explainFront("nothing faster is as accurate");
        return figure;
    }

    private String size() {
        String size = tracer.width() + "x" + tracer.height(), whole = original.width() + "x" + original.height();
        return size.equals(whole) ? size : size + ", as " + options.chartSeconds() + " seconds are too few for " + whole;
    }

    private static ChartSetting cheapestInvisible(List<ChartSetting> settings) {
        return settings.stream().filter(s -> Math.hypot(s.error, QUANTISATION) <= VISIBLE)
                .min((a, b) -> Double.compare(a.median(), b.median())).orElse(null);
    }

    private static String sentence(List<ChartSetting> settings) {
        ChartSetting best = cheapestInvisible(settings);
        ChartSetting told = best != null ? best
                : settings.stream().min((a, b) -> Double.compare(a.error, b.error)).orElseThrow();
        return String.format(Locale.ROOT, best != null
                ? "Cheapest measured with an RMSE below 1/255 over the picture: %s, RMSE %.5f in %.0f ms; single pixels differ"
                        + " by up to %.0f of 255."
                : "None measured has an RMSE below 1/255 over the picture; closest: %s, RMSE %.5f in %.0f ms; single pixels"
                        + " differ by up to %.0f of 255.",
                told.arguments, told.error, told.median(), 255 * told.maxDifference);
    }

    private List<String> table(List<ChartSetting> settings, double floor) {
        List<String> lines = new ArrayList<>(Arrays.asList(
                String.format(Locale.ROOT, "# %s %s, %d threads, Java %s; the reference's own error: %.7f",
                        options.scenes().get(0), size(), options.threads(), Runtime.version(), floor),
                "setting,median ms,lower quartile,upper quartile,rounds,rmse"));
        for (ChartSetting s : settings) {
            lines.add(String.format(Locale.ROOT, "%s,%.1f,%.1f,%.1f,%d,%.6f", s.arguments, s.median(), s.quantile(0.25),
                    s.quantile(0.75), s.millis.size(), s.error));
        }
        return lines;
    }
}
