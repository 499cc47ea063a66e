package raytracer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import raytracer.chart.Figure;
import raytracer.chart.Panel;
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

    private static final int MAX_ROUNDS = 9;

    private final Scene scene;
    private final Options options;
    private final Places places;
    private final Terminal terminal;
    private final Tracer tracer;
    private final Stopwatch elapsed = new Stopwatch();

    /** A way to render, and what came of it. */
    private static final class Setting {
        final String arguments;
        final String label;
        final int series;
        final Sampling sampling;
        final Tracer tracer;
        final List<Double> millis = new ArrayList<>();
        double error;
        double maxDifference;

        Setting(String arguments, String label, int series, Sampling sampling, Tracer tracer) {
            this.arguments = arguments;
            this.label = label;
            this.series = series;
            this.sampling = sampling;
            this.tracer = tracer;
        }

        double quantile(double part) {
            double[] sorted = millis.stream().mapToDouble(m -> m).sorted().toArray();
            return sorted[(int) (part * (sorted.length - 1) + 0.5)];
        }

        double median() {
            return quantile(0.5);
        }
    }

    ChartJob(Scene scene, Options options, Places places, Terminal terminal) {
        this.scene = scene;
        this.options = options;
        this.places = places;
        this.terminal = terminal;
        tracer = Tracer.compile(scene);
    }

    int run() throws IOException, UsageException {
        Path svg = Reason.path(options.text(Option.CHART));
        Path csv = svg.resolveSibling(Destination.baseName(svg, ".svg") + ".csv");
        places.read(Reason.path(options.scenes().get(0)), "the scene");
        places.write(svg, "the chart");
        places.write(csv, "the chart's table");
        OutputFile.require(svg);
        OutputFile.require(csv);
        List<Setting> settings = ladder();
        double warm = warmUp(settings.get(0));
        Canvas[] halves = references(warm);
        Canvas reference = Canvas.mean(halves[0], halves[1]);
        double floor = halves[0].rmse(halves[1]) / 2;
        measure(settings, reference);
        OutputFile.write(svg, figure(settings, floor).svg());
        OutputFile.write(csv, String.join("\n", table(settings, floor)) + "\n");
        terminal.answer(sentence(settings));
        return Main.DONE;
    }

    /** From the cheapest on, about. */
    private List<Setting> ladder() {
        List<Setting> all = new ArrayList<>();
        int[] sides = {1, 2, 3, 4, 6, 8}, aims = {64, 128, 255, 512, 1024};
        for (int i = 0; i < sides.length; i++) {
            int n = sides[i];
            all.add(new Setting("--samples " + n, n + "x" + n, 2, new Sampling.Grid(n), tracer));
            if (i < aims.length) {
                all.add(new Setting("--samples auto:1/" + aims[i], "auto 1/" + aims[i], 4,
                        new Sampling.Within(1.0 / aims[i]), tracer));
            }
            if (n == 3) {
                for (int depth = 1; depth < scene.maxDepth() && depth < 1 << 16; depth *= 2) {
                    all.add(new Setting("--samples 4 --maxdepth " + depth, "4x4 depth " + depth, 0, new Sampling.Grid(4),
                            tracer.withMaxDepth(depth)));
                }
            }
        }
        return all;
    }

    private Canvas render(Tracer with, Sampling sampling, String what) {
        Canvas canvas = new Canvas(scene.width(), scene.height());
        Renderer renderer = new Renderer(with, sampling, options.threads(),
                Region.whole(scene.width(), scene.height()), canvas);
        ProgressBar.during(renderer::render, terminal.err(), options.has(Option.QUIET), renderer::progress);
        if (options.has(Option.VERBOSE)) {
            terminal.tell(String.format(Locale.ROOT, "%.0f s: %s", elapsed.millis() / 1e3, what));
        }
        return canvas;
    }

    /** Lets Java compile; returns the milliseconds that one sample a pixel takes then. */
    private double warmUp(Setting simplest) {
        double best = Double.POSITIVE_INFINITY;
        for (int round = 0; round < 8 && (round < 2 || elapsed.millis() < 100.0 * options.chartSeconds()); round++) {
            Stopwatch time = new Stopwatch();
            render(simplest.tracer, simplest.sampling, "warming up");
            best = Math.min(best, time.millis());
        }
        return best;
    }

    /** Two pictures of which each is good to compare with; how they differ tells how good. */
    private Canvas[] references(double millisPerSample) {
        double affordable = REFERENCE_PART * 1e3 * options.chartSeconds() / 2 / millisPerSample;
        int count = (int) Math.max(MIN_SAMPLES, Math.min(MAX_SAMPLES, affordable));
        Canvas[] halves = new Canvas[2];
        for (int half = 0; half < 2; half++) {
            halves[half] = render(tracer, new Sampling.Lattice(count, half + 1), "half of the reference");
        }
        return halves;
    }

    /**
     * In turns, so that what disturbs the machine disturbs all; until the time is up. Settings whose turn does not come in
     * the first round are left out.
     */
    private void measure(List<Setting> settings, Canvas reference) {
        for (int round = 0; round < MAX_ROUNDS; round++) {
            for (int i = 0; i < settings.size(); i++) {
                Setting setting = settings.get(i);
                double expected = round > 0 ? setting.median() : i == 0 ? 0 : settings.get(i - 1).median();
                if (elapsed.millis() + expected > 1e3 * options.chartSeconds()) {
                    if (round == 0 && i > 0) {
                        settings.subList(i, settings.size()).clear();
                    }
                    return;
                }
                Stopwatch time = new Stopwatch();
                Canvas canvas = render(setting.tracer, setting.sampling, setting.arguments + ", setting " + (i + 1)
                        + " of " + settings.size() + ", round " + (round + 1));
                setting.millis.add(time.millis());
                setting.error = canvas.rmse(reference);
                setting.maxDifference = canvas.maxDifference(reference);
            }
        }
    }

    private Figure figure(List<Setting> settings, double floor) {
        Panel panel = new Panel("", "milliseconds, " + options.threads() + " threads",
                "RMSE of a range of [0, 1]", floor, "the reference's own error: below it nothing is known");
        panel.line(VISIBLE, "RMSE of 1/255");
        Setting best = cheapestInvisible(settings);
        for (Setting s : settings) {
            panel.point(s == best ? s.label + " (cheapest below)" : s.label, s.series, s.median(), s.quantile(0.25),
                    s.quantile(0.75), s.error);
        }
        String size = scene.width() + "x" + scene.height();
        String name = options.scenes().get(0).replaceAll("[<>&]", "");
        Figure figure = new Figure("Time against error: " + name + ", " + size,
                sentence(settings).replace("<", "&lt;"), 1, 900, 500);
        figure.add(panel);
        figure.explain(2, "n x n samples");
        figure.explain(4, "as many as an error takes");
        figure.explain(0, "fewer mirrors");
        figure.explainBars("quartiles");
        figure.explainFront("no setting measured is faster and as accurate");
        return figure;
    }

    private static Setting cheapestInvisible(List<Setting> settings) {
        return settings.stream().filter(s -> Math.hypot(s.error, QUANTISATION) <= VISIBLE)
                .min((a, b) -> Double.compare(a.median(), b.median())).orElse(null);
    }

    private static String sentence(List<Setting> settings) {
        Setting best = cheapestInvisible(settings);
        Setting told = best != null ? best
                : settings.stream().min((a, b) -> Double.compare(a.error, b.error)).orElseThrow();
        return String.format(Locale.ROOT, best != null
                ? "Cheapest measured with an RMSE below 1/255 over the picture: %s, RMSE %.5f in %.0f ms; single pixels differ"
                        + " by up to %.0f of 255."
                : "None measured has an RMSE below 1/255 over the picture; closest: %s, RMSE %.5f in %.0f ms; single pixels"
                        + " differ by up to %.0f of 255.",
                told.arguments, told.error, told.median(), 255 * told.maxDifference);
    }

    private List<String> table(List<Setting> settings, double floor) {
        List<String> lines = new ArrayList<>(Arrays.asList(
                String.format(Locale.ROOT, "# %s %dx%d, %d threads, Java %s; the reference's own error: %.6f",
                        options.scenes().get(0), scene.width(), scene.height(), options.threads(), Runtime.version(),
                        floor),
                "setting,median ms,lower quartile,upper quartile,rounds,rmse"));
        for (Setting s : settings) {
            lines.add(String.format(Locale.ROOT, "%s,%.1f,%.1f,%.1f,%d,%.6f", s.arguments, s.median(), s.quantile(0.25),
                    s.quantile(0.75), s.millis.size(), s.error));
        }
        return lines;
    }
}
