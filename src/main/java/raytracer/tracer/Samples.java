package raytracer.tracer;

/**
 * Points of the picture and the colours that their rays come to, one array per quantity. The first {@link #count} are
 * in use; rays that are near one another in the arrays are traced the faster for being near in the picture.
 */
public final class Samples {

    /** The most that are traced together. */
    public static final int CAPACITY = Rays.CAPACITY;

    public int count;

    // In pixels, from the left and from the top: a pixel's centre is half a pixel from its sides.
    public final double[] x = new double[CAPACITY];
    public final double[] y = new double[CAPACITY];

    // Linear, not cut to a range.
    public final double[] red = new double[CAPACITY];
    public final double[] green = new double[CAPACITY];
    public final double[] blue = new double[CAPACITY];

    /**
     * What the ray met: samples of the same surfaces, seen by way of the same mirrors and lit by the same lights, have
     * the same number, and others hardly ever. All triangles of one material are taken for one surface.
     */
    public final int[] path;

    private Samples(int[] path) {
        this.path = path;
    }

    public static Samples ofColour() {
        return new Samples(null);
    }

    public static Samples ofColourAndPath() {
        return new Samples(new int[CAPACITY]);
    }

    /** Adds a point. */
    public void add(double atX, double atY) {
        x[count] = atX;
        y[count++] = atY;
    }
}
