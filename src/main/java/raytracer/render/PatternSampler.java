package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/** Every pixel is the mean of the same number of samples, each cut to [0, 1] as if it were a pixel's colour. */
final class PatternSampler implements Sampler {

    private final SampleQueue queue;
    private final Pattern pattern;
    private final PixelMeans means = new PixelMeans(Tiles.CAPACITY);

    // Of the blocks of pixels whose samples make a batch.
    private final int columns;
    private final int rows;

    /** @param tracer of the picture as many times as large as the pattern is wide */
    PatternSampler(TileTracer tracer, Pattern pattern) {
        this.pattern = pattern;
        queue = new SampleQueue(tracer, false);
        queue.start(means);
        int pixels = Math.max(1, Samples.CAPACITY / pattern.count());
        columns = (int) Math.sqrt(pixels);
        rows = pixels / columns;
    }

    @Override
    public void render(Region tile, PixelSink sink) {
        means.clear(tile.pixels());
        for (int top = 0; top < tile.height(); top += rows) {
            for (int left = 0; left < tile.width(); left += columns) {
                add(tile, left, top);
                queue.flush();
            }
        }
        means.send(tile, sink);
    }

    private void add(Region tile, int left, int top) {
        for (int row = top; row < Math.min(top + rows, tile.height()); row++) {
            for (int column = left; column < Math.min(left + columns, tile.width()); column++) {
                queue.add(row * tile.width() + column, pattern, tile.x() + column, tile.y() + row);
            }
        }
    }
}
