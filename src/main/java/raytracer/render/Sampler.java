package raytracer.render;

import raytracer.tracer.PixelSink;

/** Computes pixels of a picture, for one thread. What a pixel becomes depends on the pixel alone. */
interface Sampler {

    /** @param sink gets every pixel of the tile once */
    void render(Region tile, PixelSink sink);
}
