package raytracer.tracer;

/** Takes finished pixels. */
@FunctionalInterface
public interface PixelSink {

    /**
     * @param x     from the left, from 0
     * @param y     from the top, from 0
     * @param red   linear, not cut to a range; so are the others
     */
    void set(int x, int y, double red, double green, double blue);
}
