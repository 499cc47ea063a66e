package raytracer.tracer;

/** Takes finished pixels, from many threads at the same time. */
@FunctionalInterface
public interface PixelSink {

    /**
     * Some of a row's pixels, one beside the other.
     *
     * @param x     of the first, from the left, from 0
     * @param y     from the top, from 0
     * @param count how many
     * @param red   linear, not cut to a range; so are the others
     * @param from  the index of the first pixel's colour
     */
    void setRow(int x, int y, int count, double[] red, double[] green, double[] blue, int from);

    /** Waits until there is room for the pixels from this row down to the tile's end. */
    default void awaitRoom(int row) { }

    /** A tile of this many pixels is complete, whose first row this is. */
    default void tileDone(int row, int pixels) { }
}
