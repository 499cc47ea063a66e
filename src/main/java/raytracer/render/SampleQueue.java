package raytracer.render;

import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/**
 * Samples of a tile's pixels, which are traced as soon as they make a batch. A pixel's samples are a rank-1 lattice: as
 * even as a grid, but in rows of no direction, so that no fence is in step with them (Dammertz and Keller, Image
 * Synthesis by Rank-1 Lattices, 2008; by the golden ratio, which is good for any number of samples). Its middle is the
 * pixel's, so that errors on both sides of a straight edge cancel.
 */
final class SampleQueue {

    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    private final TileTracer tracer;
    private final Samples samples = new Samples();
    private final int[] pixel = new int[Samples.CAPACITY];
    private PixelMeans means;

    SampleQueue(TileTracer tracer) {
        this.tracer = tracer;
    }

    /** From now on, samples are of these pixels; there must be none in the queue. */
    void start(PixelMeans newMeans) {
        means = newMeans;
    }

    /**
     * Adds a lattice of samples of a pixel.
     *
     * @param ofPixel its number in the tile
     * @param seed    0, or the lattice is shifted at random, by seed and pixel
     */
    void add(int ofPixel, int column, int row, int number, int seed) {
        int hash = (column * 0x9E3779B1 ^ row) * 0x85EBCA6B ^ seed;
        double shiftX = seed == 0 ? 0 : (hash >>> 16) / 65536.0;
        double shiftY = seed == 0 ? 0 : ((hash * 0xC2B2AE35) >>> 16) / 65536.0;
        for (int k = 0; k < number; k++) {
            if (samples.count == Samples.CAPACITY) {
                flush();
            }
            samples.x[samples.count] = column + fraction(shiftX + (k + 0.5) / number);
            samples.y[samples.count] = row + fraction(shiftY + 0.5 + (k - (number - 1) / 2.0) * GOLDEN);
            pixel[samples.count++] = ofPixel;
        }
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }

    /** Traces what is still in the queue, and adds the colours to the means of their pixels. */
    void flush() {
        tracer.trace(samples);
        for (int i = 0; i < samples.count; i++) {
            means.add(samples, i, pixel[i]);
        }
        samples.count = 0;
    }
}
