package raytracer.tracer.rays;

import java.util.Arrays;
import raytracer.tracer.arithmetic.Batch;

/**
 * Points of the picture and the colours that their rays come to, one array per quantity. The first {@link #count} are
 * in use; rays that are near one another in the arrays are traced the faster for being near in the picture.
 */
public final class Samples {

    /** The most that are traced together. */
    public static final int CAPACITY = Batch.CAPACITY;

    public int count;

    // In pixels, from the left and from the top: a pixel's centre is half a pixel from its sides.
    public final double[] x = new double[CAPACITY];
    public final double[] y = new double[CAPACITY];

    // Linear, not cut to a range.
    public final double[] red = new double[CAPACITY];
    public final double[] green = new double[CAPACITY];
    public final double[] blue = new double[CAPACITY];

    /** Takes the centres of a rectangle's pixels, row by row, in place of all points. */
    public void setCentres(int left, int top, int columns, int rows) {
        count = columns * rows;
        for (int i = 0; i < columns; i++) {
            x[i] = left + i + 0.5;
        }
        for (int row = 0; row < rows; row++) {
            System.arraycopy(x, 0, x, row * columns, columns);
            Arrays.fill(y, row * columns, (row + 1) * columns, top + row + 0.5);
        }
    }
}
