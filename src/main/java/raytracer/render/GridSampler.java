package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;
import raytracer.tracer.rays.Samples;

/**
 * Every pixel is the mean of n x n samples on a regular grid, each cut to [0, 1] as if it were a pixel's colour: the
 * samples are the pixels of the picture n times as large.
 */
final class GridSampler implements Sampler {

    private final TileTracer enlarged;
    private final int n;
    private final Samples samples = new Samples();
    private double[] red, green, blue;

    /** @param enlarged traces the picture n times as large */
    GridSampler(TileTracer enlarged, int n) {
        this.enlarged = enlarged;
        this.n = n;
    }

    @Override
    public void render(Region tile, PixelSink sink) {
        int left = tile.x(), top = tile.y(), columns = tile.width(), rows = tile.height();
        if (n == 1) {
            // A pixel's one sample is its colour, and is cut where it becomes a byte.
            enlarged.traceCentres(left, top, columns, rows, samples);
            sink.setPixels(left, top, columns, rows, samples.red, samples.green, samples.blue);
            return;
        }
        red = new double[tile.pixels()];
        green = new double[tile.pixels()];
        blue = new double[tile.pixels()];
        // As many whole pixels as can be traced together, or part of one.
        int side = n > Tracer.TILE_SIDE ? Tracer.TILE_SIDE : Tracer.TILE_SIDE / n * n;
        for (int y = 0; y < rows * n; y += side) {
            for (int x = 0; x < columns * n; x += side) {
                int w = Math.min(side, columns * n - x), h = Math.min(side, rows * n - y);
                enlarged.traceCentres(left * n + x, top * n + y, w, h, samples);
                addSamples(x, y, w, columns);
            }
        }
        divide(red);
        divide(green);
        divide(blue);
        sink.setPixels(left, top, columns, rows, red, green, blue);
    }

    /** Adds a rectangle of samples, of this width and from this column and row of the tile's on, to their pixels. */
    private void addSamples(int x, int y, int w, int columns) {
        for (int first = 0, row = y; first < samples.count; first += w, row++) {
            int pixels = row / n * columns;
            for (int column = 0; column < w; column++) {
                int pixel = pixels + (x + column) / n;
                red[pixel] += PixelMeans.cut(samples.red[first + column]);
                green[pixel] += PixelMeans.cut(samples.green[first + column]);
                blue[pixel] += PixelMeans.cut(samples.blue[first + column]);
            }
        }
    }

    private void divide(double[] sums) {
        for (int i = 0; i < sums.length; i++) {
            sums[i] /= n * n;
        }
    }
}
