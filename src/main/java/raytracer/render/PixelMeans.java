package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.rays.Samples;

/** By pixel of a tile, the mean colour of its samples, and how much they differ. */
final class PixelMeans {

    private final double[] red;
    private final double[] green;
    private final double[] blue;
    private final double[] squares;
    private final int[] count;

    /** The path of a pixel's samples, and whether they have more than one; if samples have paths. */
    private final int[] path;
    private final boolean[] mixed;

    PixelMeans(int pixels) {
        red = new double[pixels];
        green = new double[pixels];
        blue = new double[pixels];
        squares = new double[pixels];
        count = new int[pixels];
        path = new int[pixels];
        mixed = new boolean[pixels];
    }

    /** @param pixel of each sample, from index {@code first} on */
    void take(Samples samples, int[] pixel, int first) {
        if (samples.path != null) {
            takePaths(samples, pixel, first);
        }
        for (int i = 0; i < samples.count; i++) {
            int p = pixel[first + i];
            double r = cut(samples.red[i]), g = cut(samples.green[i]), b = cut(samples.blue[i]);
            red[p] += r;
            green[p] += g;
            blue[p] += b;
            squares[p] += r * r + g * g + b * b;
            count[p]++;
        }
    }

    private void takePaths(Samples samples, int[] pixel, int first) {
        for (int i = 0; i < samples.count; i++) {
            int p = pixel[first + i];
            boolean isFirst = count[p] == 0 && (i == 0 || pixel[first + i - 1] != p);
            mixed[p] |= !isFirst && path[p] != samples.path[i];
            path[p] = samples.path[i];
        }
    }

    /** Whether all samples of two pixels have the same path. */
    boolean areAlike(int p, int q) {
        return !mixed[p] && !mixed[q] && path[p] == path[q];
    }

    /** To [0, 1]; what is no number stays none. */
    private static double cut(double c) {
        return c < 0 ? 0 : c > 1 ? 1 : c;
    }

    /** Forgets a pixel's samples. */
    void clear(int p) {
        red[p] = green[p] = blue[p] = squares[p] = 0;
        count[p] = 0;
    }

    double red(int p) {
        return red[p] / count[p];
    }

    double green(int p) {
        return green[p] / count[p];
    }

    double blue(int p) {
        return blue[p] / count[p];
    }

    /** The variance of a pixel's samples: the mean of the three components'. */
    double variance(int p) {
        double n = count[p];
        double variance = (squares[p] - (red[p] * red[p] + green[p] * green[p] + blue[p] * blue[p]) / n) / (3 * n);
        return variance > 0 ? variance : 0;
    }

    /** Sends all pixels of a rectangle, of which these are the means. */
    void send(int left, int top, int columns, int rows, PixelSink sink) {
        send(0, left, top, columns, rows, sink);
    }

    /** Sends some of these pixels, from one on: a rectangle, one row after the other. */
    void send(int first, int left, int top, int columns, int rows, PixelSink sink) {
        int pixels = columns * rows;
        double[] r = new double[pixels], g = new double[pixels], b = new double[pixels];
        for (int i = 0; i < pixels; i++) {
            r[i] = red(first + i);
            g[i] = green(first + i);
            b[i] = blue(first + i);
        }
        sink.setPixels(left, top, columns, rows, r, g, b);
    }
}
