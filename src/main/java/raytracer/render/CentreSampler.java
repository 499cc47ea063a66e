package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/** Every pixel is one sample, in its middle; it is cut where it becomes a byte. */
record CentreSampler(TileTracer tracer, Samples samples) implements Sampler {

    @Override
    public void render(Region tile, PixelSink sink) {
        tracer.traceCentres(tile.x(), tile.y(), tile.width(), tile.height(), samples);
        sink.setPixels(tile.x(), tile.y(), tile.width(), tile.height(), samples.red, samples.green, samples.blue);
    }
}
