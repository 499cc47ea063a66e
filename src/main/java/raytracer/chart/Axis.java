package raytracer.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A logarithmic axis that ends where its values end, at the next number of 1, 2 or 5 times a power of ten.
 *
 * @param low  the end with the least values; above 0
 * @param band up to here, from the low end on, values cannot be told from none; 0 if there is no such band
 */
record Axis(double low, double high, double band) {

    /** What a band for none adds below the least value: room for dots. */
    private static final double ROOM = 4;

    /** Numbers that are not positive have no place but in the band. */
    static Axis around(List<Double> values, double band) {
        double min = band > 0 ? band : Double.POSITIVE_INFINITY, max = band > 0 ? 10 * band : 0;
        for (double v : values) {
            if (v > 0) {
                min = Math.min(min, v);
                max = Math.max(max, v);
            }
        }
        double low = band > 0 ? Math.min(band / ROOM, min / 2) : stepBelow(min);
        double high = stepAbove(max);
        return new Axis(low, high > 2 * low ? high : stepAbove(2 * low), band);
    }

    private static double stepBelow(double v) {
        double decade = Math.pow(10, Math.floor(Math.log10(v)));
        return decade * (v >= 5 * decade ? 5 : v >= 2 * decade ? 2 : 1);
    }

    private static double stepAbove(double v) {
        double below = stepBelow(v);
        return below == v ? v : stepBelow(below * 2.6);
    }

    /** From 0 at the low end to 1 at the high one; values of 0 are in the middle of the band. */
    double at(double v) {
        double shown = v > 0 ? v : Math.sqrt(low * band);
        return Math.log(shown / low) / Math.log(high / low);
    }

    /** The ends first, if they are numbers; then the powers of ten; then what is between them, if there are few. */
    List<Double> ticks() {
        List<Double> ticks = new ArrayList<>();
        if (band == 0) {
            ticks.add(low);
        }
        ticks.add(high);
        addBetween(1, ticks);
        if (high < 100 * low) {
            addBetween(2, ticks);
            addBetween(5, ticks);
        }
        return ticks;
    }

    private void addBetween(int step, List<Double> ticks) {
        for (int e = (int) Math.floor(Math.log10(low)); e <= Math.log10(high); e++) {
            double tick = step * Math.pow(10, e);
            if (tick > low && tick >= band && tick < high) {
                ticks.add(tick);
            }
        }
    }

    /** A tick in words of SVG. */
    static String name(double tick) {
        int exponent = (int) Math.floor(Math.log10(tick) + 1e-9);
        if (exponent >= -3 && exponent < 4) {
            return String.format(Locale.ROOT, "%." + Math.max(0, -exponent) + "f", tick);
        }
        long factor = Math.round(tick / Math.pow(10, exponent));
        return (factor == 1 ? "" : factor + "&#183;") + "10<tspan dy='-5' font-size='8'>" + exponent + "</tspan>";
    }
}
