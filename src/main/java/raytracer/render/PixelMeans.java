package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.Samples;

/** By pixel of a tile, the mean colour of its samples, and how much they differ. */
final class PixelMeans {

    private final double[] red;
    private final double[] green;
    private final double[] blue;
    private final double[] squares;
    private final int[] count;

    // By sample: which pixel it belongs to.
    private final int[] pixel = new int[Samples.CAPACITY];
    private int expected;

    PixelMeans(int pixels) {
        red = new double[pixels];
        green = new double[pixels];
        blue = new double[pixels];
        squares = new double[pixels];
        count = new int[pixels];
    }

    /** The next sample will be one of this pixel. */
    void expect(int of) {
        pixel[expected++] = of;
    }

    /** Notes each pixel's path, and whether its samples have different ones; before they are taken. */
    void notePaths(Samples samples, int[] path, boolean[] mixed) {
        for (int i = 0; i < expected; i++) {
            int p = pixel[i];
            boolean first = count[p] == 0 && (i == 0 || pixel[i - 1] != p);
            mixed[p] |= !first && path[p] != samples.path[i];
            path[p] = samples.path[i];
        }
    }

    /** Takes the samples that are expected. */
    void take(Samples samples) {
        for (int i = 0; i < expected; i++) {
            int p = pixel[i];
            double r = cut(samples.red[i]), g = cut(samples.green[i]), b = cut(samples.blue[i]);
            red[p] += r;
            green[p] += g;
            blue[p] += b;
            squares[p] += r * r + g * g + b * b;
            count[p]++;
        }
        expected = 0;
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

    void send(int p, int x, int y, PixelSink sink) {
        sink.set(x, y, red(p), green(p), blue(p));
    }
}
