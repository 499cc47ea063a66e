package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.TileTracer;

/** Every pixel is the mean of n x n samples on a regular grid, each cut to [0, 1] as if it were a pixel's colour. */
final class GridSampler implements Sampler {

    private final TileTracer tracer;
    private final int n;
    private final Samples samples = Samples.ofColour();
    private final Points points = new Points();

    GridSampler(TileTracer tracer, int n) {
        this.tracer = tracer;
        this.n = n;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        PixelMeans means = new PixelMeans(columns * rows);
        addGrids(left, top, columns, rows);
        points.trace(tracer, samples, means);
        means.send(left, top, columns, rows, sink);
    }

    private void addGrids(int left, int top, int columns, int rows) {
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            points.addGrid(pixel, left + pixel % columns, top + pixel / columns, n);
        }
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
