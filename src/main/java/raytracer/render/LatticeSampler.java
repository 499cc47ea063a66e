package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/** Every pixel is the mean of as many samples, of a lattice ({@link Points}). */
final class LatticeSampler implements Sampler {

    private final TileTracer tracer;
    private final Sampling.Lattice lattice;
    private final Points points = new Points();

    LatticeSampler(TileTracer tracer, Sampling.Lattice lattice) {
        this.tracer = tracer;
        this.lattice = lattice;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        PixelMeans means = new PixelMeans(columns * rows);
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            points.add(pixel, left + pixel % columns, top + pixel / columns, lattice.count(), lattice.seed());
            // Not all at a time, as there may be very many samples a pixel.
            if (points.count() >= Samples.CAPACITY) {
                points.trace(tracer, means);
            }
        }
        points.trace(tracer, means);
        means.send(left, top, columns, rows, sink);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
