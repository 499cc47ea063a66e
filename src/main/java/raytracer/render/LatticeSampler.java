package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;

/** Every pixel is the mean of the same number of samples, a lattice ({@link SampleQueue}). */
final class LatticeSampler implements Sampler {

    private final TileTracer tracer;
    private final Sampling.Lattice lattice;
    private final SampleQueue queue;

    LatticeSampler(TileTracer tracer, Sampling.Lattice lattice) {
        this.tracer = tracer;
        this.lattice = lattice;
        queue = new SampleQueue(tracer);
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        PixelMeans means = new PixelMeans(columns * rows);
        queue.start(means);
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            queue.add(pixel, left + pixel % columns, top + pixel / columns, lattice.count(), lattice.seed());
        }
        queue.flush();
        means.send(left, top, columns, rows, sink);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
