package raytracer.cli;

import java.util.ArrayList;
import java.util.List;
import raytracer.render.Sampling;

/** A way to render that is charted, and what came of it. */
final class ChartSetting {

    final String arguments;
    final String label;
    final int series;
    final Sampling sampling;
    final int maxDepth;

    /** How long it will take, as far as is known. */
    double expectedMillis;
    final List<Double> millis = new ArrayList<>();
    double error;
    double maxDifference;

    private ChartSetting(String arguments, String label, int series, Sampling sampling, int maxDepth, double expectedMillis) {
        this.arguments = arguments;
        this.label = label;
        this.series = series;
        this.sampling = sampling;
        this.maxDepth = maxDepth;
        this.expectedMillis = expectedMillis;
    }

    /**
     * All that are tried, about from the cheapest on.
     *
     * @param maxDepth        of the scene
     * @param millisPerSample of all pixels
     */
    static List<ChartSetting> ladder(int maxDepth, double millisPerSample) {
        List<ChartSetting> all = new ArrayList<>();
        int[] sides = {1, 2, 3, 4, 6, 8}, aims = {64, 128, 255, 512, 1024};
        for (int i = 0; i < sides.length; i++) {
            int n = sides[i];
            all.add(new ChartSetting("--samples " + n, n + "x" + n, 2, new Sampling.Grid(n), maxDepth, n * n * millisPerSample));
            if (i < aims.length) {
                // Errors fall with the 3/4th power of the number of samples; 1/64 takes about three.
                double expected = 3 * Math.pow(aims[i] / 64.0, 4 / 3.0) * millisPerSample;
                all.add(new ChartSetting("--samples auto:1/" + aims[i], "auto 1/" + aims[i], 4,
                        new Sampling.Within(1.0 / aims[i]), maxDepth, expected));
            }
            if (n == 3) {
                for (int depth = 1; depth < maxDepth && depth < 1 << 16; depth *= 2) {
                    all.add(new ChartSetting("--samples 4 --maxdepth " + depth, "4x4 depth " + depth, 0, new Sampling.Grid(4),
                            depth, 16 * millisPerSample));
                }
            }
        }
        return all;
    }

    double median() {
        return quantile(0.5);
    }

    /** Of the times; between two of them, in proportion. */
    double quantile(double part) {
        double[] sorted = millis.stream().mapToDouble(m -> m).sorted().toArray();
        double at = part * (sorted.length - 1);
        int below = (int) at, above = Math.min(below + 1, sorted.length - 1);
        return sorted[below] + (at - below) * (sorted[above] - sorted[below]);
    }
}
