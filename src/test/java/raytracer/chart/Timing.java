package raytracer.chart;

import java.util.Arrays;
import java.util.List;

/** Nanoseconds per item: the median and the quartiles of rounds in which all contestants took turns. */
record Timing(double median, double low, double high) {

    private static final int WARM_UP = 12;
    private static final int ROUNDS = 21;

    /** Work that is the same every time; what it returns keeps it from being optimised away. */
    interface Work {
        double run();
    }

    private static volatile double sink;

    /**
     * Times several, interleaved, so that what disturbs the machine disturbs all.
     *
     * @param items by how many a run's time is divided
     */
    static Timing[] of(List<Work> works, double items) {
        return of(works, items, WARM_UP, ROUNDS);
    }

    static Timing[] of(List<Work> works, double items, int warmUp, int rounds) {
        double[][] times = new double[works.size()][rounds];
        for (int round = -warmUp; round < rounds; round++) {
            for (int k = 0; k < works.size(); k++) {
                long start = System.nanoTime();
                sink += works.get(k).run();
                if (round >= 0) {
                    times[k][round] = (System.nanoTime() - start) / items;
                }
            }
        }
        return Arrays.stream(times).map(Timing::summary).toArray(Timing[]::new);
    }

    private static Timing summary(double[] times) {
        Arrays.sort(times);
        return new Timing(times[times.length / 2], times[times.length / 4], times[3 * times.length / 4]);
    }
}
