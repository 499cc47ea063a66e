package raytracer.render;

import raytracer.image.Image;
import raytracer.tracer.Tracer;

/** Renders whole pictures for tests. */
public final class Rendering {

    private Rendering() { }

    /** One sample a pixel. */
    public static Renderer of(Tracer tracer, int threads, Image image) {
        return new Renderer(tracer, Sampling.CENTRES, threads, Region.whole(image.toBufferedImage().getWidth(), image.toBufferedImage().getHeight()), image);
    }
}
