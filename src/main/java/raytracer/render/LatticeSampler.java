package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.TileTracer;

/** Every pixel is the mean of the same number of samples, a lattice ({@link SampleQueue}). */
final class LatticeSampler implements Sampler {

    private final Sampling.Lattice lattice;
    private final SampleQueue queue;

    LatticeSampler(TileTracer tracer, Sampling.Lattice lattice) {
        this.lattice = lattice;
        queue = new SampleQueue(tracer);
    }

    @Override
    public void render(Region tile, PixelSink sink) {
        PixelMeans means = new PixelMeans(tile.pixels());
        queue.start(means);
        for (int pixel = 0; pixel < tile.pixels(); pixel++) {
            queue.add(pixel, tile.column(pixel), tile.row(pixel), lattice.count(), lattice.seed());
        }
        queue.flush();
        means.send(tile, sink);
    }
}
