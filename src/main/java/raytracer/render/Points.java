package raytracer.render;

import java.util.Arrays;
import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/**
 * Points of the picture that are to be sampled, each for one pixel of a tile. A pixel's points are a lattice: as even as a
 * grid, but in rows of no direction, so that no fence is in step with them (Dammertz and Keller, Image Synthesis by Rank-1
 * Lattices, 2008; of the golden ratio, which is a good one for any number of points). Its middle is the pixel's, so that
 * the errors on both sides of a straight edge make up for each other.
 */
final class Points {

    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    private double[] x = new double[Samples.CAPACITY];
    private double[] y = new double[Samples.CAPACITY];
    private int[] pixel = new int[Samples.CAPACITY];
    private int count;
    private final Samples samples = new Samples();

    int count() {
        return count;
    }

    /**
     * Adds a lattice of so many points.
     *
     * @param ofPixel its number in the tile
     * @param seed    0, or lattices are shifted differently in every pixel and for every seed
     */
    void add(int ofPixel, int column, int row, int points, int seed) {
        int hash = (column * 0x9E3779B1 ^ row) * 0x85EBCA6B ^ seed;
        double shiftX = seed == 0 ? 0 : (hash >>> 16) / 65536.0;
        double shiftY = seed == 0 ? 0 : ((hash * 0xC2B2AE35) >>> 16) / 65536.0;
        for (int k = 0; k < points; k++) {
            add(ofPixel, column + fraction(shiftX + (k + 0.5) / points),
                    row + fraction(shiftY + 0.5 + (k - (points - 1) / 2.0) * GOLDEN));
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
