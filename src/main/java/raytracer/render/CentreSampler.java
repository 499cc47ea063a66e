package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.TileTracer;

/** Every pixel is the one sample at its centre: the colour goes on uncut, and no means are kept. */
final class CentreSampler implements Sampler {

    private final TileTracer tracer;
    private final Samples samples = new Samples();

    CentreSampler(TileTracer tracer) {
        this.tracer = tracer;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        tracer.traceCentres(left, top, columns, rows, samples);
        sink.setPixels(left, top, columns, rows, samples.red, samples.green, samples.blue);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
