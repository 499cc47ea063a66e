package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;

/** Computes pixels of a picture, for one thread. What a pixel becomes depends on the pixel alone. */
interface Sampler {

    /**
     * Computes a rectangle of pixels.
     *
     * @param sink gets every pixel of the rectangle once
     */
    void render(int left, int top, int columns, int rows, PixelSink sink);

    /** The rays that were traced since this was made. */
    RayCounts counts();
}
