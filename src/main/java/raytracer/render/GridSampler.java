package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;

/**
 * Every pixel is the mean of n x n samples on a regular grid, each cut to [0, 1] as if it were a pixel's colour: the
 * samples are the pixels of the picture n times as large.
 */
final class GridSampler implements Sampler {

    private final TileTracer enlarged;
    private final int n;
    private final Samples samples = Samples.ofColour();
    private double[] red, green, blue;

    /** @param enlarged traces the picture n times as large */
    GridSampler(TileTracer enlarged, int n) {
        this.enlarged = enlarged;
        this.n = n;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        red = new double[columns * rows];
        green = new double[columns * rows];
        blue = new double[columns * rows];
        // As many whole pixels as can be traced together, or part of one.
        int step = Math.max(n, Tracer.TILE_SIDE / n * n);
        int side = Math.min(step, Tracer.TILE_SIDE);
        for (int y = 0; y < rows * n; y += side) {
            for (int x = 0; x < columns * n; x += side) {
                int w = Math.min(side, columns * n - x), h = Math.min(side, rows * n - y);
                enlarged.traceCentres(left * n + x, top * n + y, w, h, samples);
                addSamples(left * n, top * n, columns);
            }
        }
        sink.setPixels(left, top, columns, rows, red, green, blue);
    }

    private void addSamples(int left, int top, int columns) {
        double part = 1.0 / (n * n);
        for (int i = 0; i < samples.count; i++) {
            int pixel = ((int) samples.y[i] - top) / n * columns + ((int) samples.x[i] - left) / n;
            red[pixel] += part * cut(samples.red[i]);
            green[pixel] += part * cut(samples.green[i]);
            blue[pixel] += part * cut(samples.blue[i]);
        }
    }

    /** To [0, 1]; what is no number stays none. */
    private static double cut(double c) {
        return c < 0 ? 0 : c > 1 ? 1 : c;
    }

    @Override
    public RayCounts counts() {
        return enlarged.counts();
    }
}
