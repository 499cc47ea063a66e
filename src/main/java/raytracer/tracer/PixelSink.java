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

    /** Waits until there is room for the pixels from this row down to the tile's end. */
    default void awaitRoom(int row) { }

    /** A tile of this many pixels is complete, whose first row this is. */
    default void tileDone(int row, int pixels) { }
}
