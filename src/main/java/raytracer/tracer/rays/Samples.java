package raytracer.tracer.rays;

import raytracer.tracer.arithmetic.Batch;

/**
 * Points of the picture and the colours that their rays come to, one array per quantity. The first {@link #count} are
 * in use; rays that are near one another in the arrays are traced the faster for being near in the picture.
 */
public final class Samples {

    /** The most that are traced together. */
    public static final int CAPACITY = Batch.CAPACITY;

    private int count;

    // In pixels, from the left and from the top: a pixel's centre is half a pixel from its sides.
    public final double[] x = new double[CAPACITY];
    public final double[] y = new double[CAPACITY];

    /** Around all points: the least and greatest x, then y. */
    public final double[] bounds = new double[4];

    // Linear, not cut to a range.
    public final double[] red = new double[CAPACITY];
    public final double[] green = new double[CAPACITY];
    public final double[] blue = new double[CAPACITY];

    public Samples() {
        clear();
    }

    public int count() {
        return count;
    }

    /** Takes out all points. */
    public void clear() {
        count = 0;
        bounds[0] = bounds[2] = Double.POSITIVE_INFINITY;
        bounds[1] = bounds[3] = Double.NEGATIVE_INFINITY;
    }

    /** Adds a point. */
    public void add(double atX, double atY) {
        x[count] = atX;
        y[count++] = atY;
        include(atX, atX, atY, atY);
    }

    /**
     * Adds points of a pattern, from one on.
     *
     * @param patternX from 0 to 1, or to how many samples a pixel is wide, as is {@code patternY}
     * @param atX      added to all, as is {@code atY}
     */
    public void add(double[] patternX, double[] patternY, int from, int number, double atX, double atY, int width) {
        for (int i = 0; i < number; i++) {
            x[count + i] = atX + patternX[from + i];
        }
        for (int i = 0; i < number; i++) {
            y[count + i] = atY + patternY[from + i];
        }
        count += number;
        include(atX, atX + width, atY, atY + width);
    }

    private void include(double minX, double maxX, double minY, double maxY) {
        bounds[0] = Math.min(bounds[0], minX);
        bounds[1] = Math.max(bounds[1], maxX);
        bounds[2] = Math.min(bounds[2], minY);
        bounds[3] = Math.max(bounds[3], maxY);
    }

    /** Takes the centres of a rectangle's pixels, row by row, in place of all points. */
    public void setCentres(int atX, int atY, int columns, int rows) {
        clear();
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                x[count] = atX + column + 0.5;
                y[count++] = atY + row + 0.5;
            }
        }
        include(atX, atX + columns, atY, atY + rows);
    }
}
