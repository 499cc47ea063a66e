package raytracer.render;

import java.util.Arrays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.TileTracer;

/** Points of the picture that are to be sampled, each for one pixel of a tile. */
final class Points {

    private double[] x = new double[Samples.CAPACITY];
    private double[] y = new double[Samples.CAPACITY];
    private int[] pixel = new int[Samples.CAPACITY];
    private int count;

    void add(int ofPixel, double atX, double atY) {
        if (count == pixel.length) {
            x = Arrays.copyOf(x, 2 * count);
            y = Arrays.copyOf(y, 2 * count);
            pixel = Arrays.copyOf(pixel, 2 * count);
        }
        x[count] = atX;
        y[count] = atY;
        pixel[count++] = ofPixel;
    }

    /** Adds the middles of n x n squares into which a pixel is cut, whose corner is at (left, top). */
    void addGrid(int ofPixel, int left, int top, int n) {
        for (int k = 0; k < n * n; k++) {
            add(ofPixel, left + (k % n + 0.5) / n, top + (k / n + 0.5) / n);
        }
    }

    /**
     * Traces all points, adds their colours to the means of their pixels, and forgets them. No loop over points is
     * here: C2 would compile the whole tracer into it, for seconds.
     */
    void trace(TileTracer tracer, Samples samples, PixelMeans means) {
        for (int from = 0; from < count; from += Samples.CAPACITY) {
            samples.count = Math.min(Samples.CAPACITY, count - from);
            System.arraycopy(x, from, samples.x, 0, samples.count);
            System.arraycopy(y, from, samples.y, 0, samples.count);
            tracer.trace(samples);
            means.take(samples, pixel, from);
        }
        count = 0;
    }
}
