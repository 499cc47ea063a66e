package raytracer.render;

import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/**
 * Samples of a tile's pixels, which are traced as soon as they make a batch. A pixel's samples are a rank-1 lattice: as
 * even as a grid, but in rows of no direction, so that no fence is in step with them (Dammertz and Keller, Image
 * Synthesis by Rank-1 Lattices, 2008; by the golden ratio, which is good for most numbers of samples). Its middle is
 * the pixel's, so that errors on both sides of a straight edge cancel.
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
        // Mirrored in half of the pixels, and axes exchanged in half: what is in step with one lattice is not with all.
        double step = step(number) * ((hash >> 20 & 1) == 0 ? 1 : -1);
        boolean isExchanged = (hash >> 21 & 1) == 0;
        for (int k = 0; k < number; k++) {
            if (samples.count == Samples.CAPACITY) {
                flush();
            }
            double even = fraction(shiftX + (k + 0.5) / number);
            double other = fraction(shiftY + 0.5 + (k - (number - 1) / 2.0) * step);
            samples.x[samples.count] = column + (isExchanged ? other : even);
            samples.y[samples.count] = row + (isExchanged ? even : other);
            pixel[samples.count++] = ofPixel;
        }
    }

    /**
     * How far it is from one of so many rows' samples to that of the next: for some numbers not by the golden ratio. On
     * random edges that is off by .69 to .79 times v^1/2 N^-3/4, but by .79 to .88 for these, of which all steps were
     * tried, and which are off by .71 to .73 so.
     */
    private static double step(int number) {
        return switch (number) {
            case 6 -> .432;
            case 9 -> .302;
            case 10 -> .388;
            case 11 -> .416;
            case 15 -> .41;
            case 22 -> .38;
            case 24 -> .296;
            case 28 -> .29;
            case 39 -> .378;
            case 40 -> .422;
            default -> GOLDEN;
        };
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
