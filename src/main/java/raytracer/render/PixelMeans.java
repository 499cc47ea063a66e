package raytracer.render;

import java.util.Arrays;
import raytracer.tracer.PixelSink;
import raytracer.tracer.rays.Samples;

/** By pixel of a tile, the mean colour of its samples, and how much they differ. */
final class PixelMeans {

    private final double[] red;
    private final double[] green;
    private final double[] blue;
    private final double[] squares;
    private final int[] count;

    PixelMeans(int pixels) {
        red = new double[pixels];
        green = new double[pixels];
        blue = new double[pixels];
        squares = new double[pixels];
        count = new int[pixels];
    }

    /** Takes out the samples of the first so many pixels. */
    void clear(int pixels) {
        Arrays.fill(red, 0, pixels, 0);
        Arrays.fill(green, 0, pixels, 0);
        Arrays.fill(blue, 0, pixels, 0);
        Arrays.fill(squares, 0, pixels, 0);
        Arrays.fill(count, 0, pixels, 0);
    }

    /** Cuts the colours of all samples to [0, 1], as if they were pixels'; what is no number stays none. */
    static void cut(Samples samples) {
        cut(samples.red, samples.count());
        cut(samples.green, samples.count());
        cut(samples.blue, samples.count());
    }

    private static void cut(double[] component, int to) {
        for (int i = 0; i < to; i++) {
            component[i] = Math.min(1, Math.max(0, component[i]));
        }
    }

    /** Adds samples, from one up to before another, that are cut, to a pixel. */
    void add(Samples samples, int from, int to, int pixel) {
        double r = red[pixel], g = green[pixel], b = blue[pixel];
        for (int i = from; i < to; i++) {
            r += samples.red[i];
            g += samples.green[i];
            b += samples.blue[i];
        }
        red[pixel] = r;
        green[pixel] = g;
        blue[pixel] = b;
        count[pixel] += to - from;
    }

    /** Adds what the same samples' variance is computed from. */
    void addSquares(Samples samples, int from, int to, int pixel) {
        for (int i = from; i < to; i++) {
            double r = samples.red[i], g = samples.green[i], b = samples.blue[i];
            squares[pixel] += r * r + g * g + b * b;
        }
    }

    /** The variance of a pixel's samples: the mean of the three components'. */
    double variance(int p) {
        double n = count[p];
        double variance = (squares[p] - (red[p] * red[p] + green[p] * green[p] + blue[p] * blue[p]) / n) / (3 * n);
        return variance > 0 ? variance : 0;
    }

    /** The square of how far a pixel's mean is from that of other samples: the mean of the three components'. */
    double squaredDifference(PixelMeans others, int p) {
        double r = red[p] / count[p] - others.red[p] / others.count[p];
        double g = green[p] / count[p] - others.green[p] / others.count[p];
        double b = blue[p] / count[p] - others.blue[p] / others.count[p];
        return (r * r + g * g + b * b) / 3;
    }

    /** Sends all pixels of a tile, of which these are the means, which so are no sums any more. */
    void send(Region tile, PixelSink sink) {
        for (int p = 0; p < tile.pixels(); p++) {
            red[p] /= count[p];
            green[p] /= count[p];
            blue[p] /= count[p];
        }
        sink.setPixels(tile.x(), tile.y(), tile.width(), tile.height(), red, green, blue);
    }
}
