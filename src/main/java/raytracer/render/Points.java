package raytracer.render;

import java.util.Arrays;
import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/**
 * Points of the picture that are to be sampled, each for one pixel of a tile: those of the R2 sequence (Roberts, The
 * Unreasonable Effectiveness of Quasirandom Sequences, 2018), shifted differently in every pixel. They are as even as a
 * grid, but in rows of no direction, and any number of them can be continued.
 */
final class Points {

    /** The root of x^3 = x + 1, whose powers divide a square most evenly. */
    private static final double PLASTIC = 1.3247179572447460;

    private double[] x = new double[Samples.CAPACITY];
    private double[] y = new double[Samples.CAPACITY];
    private int[] pixel = new int[Samples.CAPACITY];
    private int count;
    private final Samples samples = new Samples();

    int count() {
        return count;
    }

    /**
     * Adds points {@code from} to {@code to - 1} of a pixel's sequence.
     *
     * @param ofPixel its number in the tile
     * @param seed    of different ones, sequences are different
     */
    void add(int ofPixel, int column, int row, int from, int to, int seed) {
        int hash = (column * 0x9E3779B1 ^ row) * 0x85EBCA6B ^ seed;
        double shiftX = (hash >>> 16) / 65536.0, shiftY = ((hash * 0xC2B2AE35) >>> 16) / 65536.0;
        for (int k = from; k < to; k++) {
            add(ofPixel, column + fraction(shiftX + k / PLASTIC), row + fraction(shiftY + k / (PLASTIC * PLASTIC)));
        }
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }

    private void add(int ofPixel, double atX, double atY) {
        if (count == pixel.length) {
            x = Arrays.copyOf(x, 2 * count);
            y = Arrays.copyOf(y, 2 * count);
            pixel = Arrays.copyOf(pixel, 2 * count);
        }
        x[count] = atX;
        y[count] = atY;
        pixel[count++] = ofPixel;
    }

    /**
     * Traces all points, adds their colours to the means of their pixels, and forgets them. No loop over points is
     * here: C2 would compile the whole tracer into it, for seconds.
     */
    void trace(TileTracer tracer, PixelMeans means) {
        for (int from = 0; from < count; from += Samples.CAPACITY) {
            samples.count = Math.min(Samples.CAPACITY, count - from);
            System.arraycopy(x, from, samples.x, 0, samples.count);
            System.arraycopy(y, from, samples.y, 0, samples.count);
            tracer.trace(samples);
            means.add(samples, pixel, from);
        }
        count = 0;
    }
}
