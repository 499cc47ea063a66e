package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Samples;
import raytracer.tracer.TileTracer;

/** Every pixel is the one sample at its centre: the colour goes on uncut, and no means are kept. */
final class CentreSampler implements Sampler {

    private final TileTracer tracer;
    private final Samples samples = Samples.ofColour();

    CentreSampler(TileTracer tracer) {
        this.tracer = tracer;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        for (int row = 0; row < rows; row++) {
            pointAtRow(left, top + row, columns);
        }
        tracer.trace(samples);
        for (int row = 0; row < rows; row++) {
            sink.setRow(left, top + row, columns, samples.red, samples.green, samples.blue, row * columns);
        }
        samples.count = 0;
    }

    private void pointAtRow(int left, int y, int columns) {
        for (int x = left; x < left + columns; x++) {
            samples.add(x + 0.5, y + 0.5);
        }
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
