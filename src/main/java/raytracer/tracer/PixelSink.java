package raytracer.tracer;

/** Takes finished pixels, from many threads at the same time. */
@FunctionalInterface
public interface PixelSink {

    /**
     * The pixels of a rectangle, row by row.
     *
     * @param x   of the first, from the left, from 0
     * @param y   of the first, from the top, from 0
     * @param red linear, not cut to a range; so are the others. They may be overwritten.
     */
    void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue);
}
