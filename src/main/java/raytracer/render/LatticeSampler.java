package raytracer.render;

import raytracer.tracer.PixelSink;

/** Every pixel is the mean of the same number of samples, a lattice ({@link SampleQueue}). */
record LatticeSampler(SampleQueue queue, Sampling.Lattice lattice) implements Sampler {

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
