package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;
import raytracer.tracer.rays.Samples;

/**
 * Spends samples where a pixel is not settled. The first are at the pixels' corners; a pixel of which it is proved that
 * its corners show all there is in it is settled. Every other gets some initial samples, and by how much those differ
 * decides how many more ({@link SampleBudget}).
 */
final class AdaptiveSampler implements Sampler {

    /** Pixels along a tile's side: their corners are traced together. */
    static final int TILE_SIDE = Tracer.TILE_SIDE - 1;
    static final int TILE_PIXELS = TILE_SIDE * TILE_SIDE;

    /** The samples of each pixel at corners. */
    static final double FIRST_SAMPLES = (double) Samples.CAPACITY / TILE_PIXELS;

    private final TileTracer tracer;
    private final double error;
    private final SampleBudget.Chosen budget;
    private final Samples corners = new Samples();
    private final SampleQueue queue;

    private Region tile;
    private PixelMeans means;

    AdaptiveSampler(TileTracer tracer, double error, SampleBudget.Chosen budget) {
        this.tracer = tracer;
        this.error = error;
        this.budget = budget;
        queue = new SampleQueue(tracer);
    }

    @Override
    public void render(Region newTile, PixelSink sink) {
        tile = newTile;
        means = new PixelMeans(tile.pixels());
        queue.start(means);
        boolean[] settled = tracer.traceCorners(tile.x(), tile.y(), tile.width(), tile.height(), error, corners);
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (settled[pixel]) {
                addCorners(pixel);
            } else {
                add(pixel, budget.initial());
            }
        }
        queue.flush();
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (!settled[pixel]) {
                add(pixel, budget.samples(means.variance(pixel)) - budget.initial());
            }
        }
        queue.flush();
        means.send(tile, sink);
    }

    /** Gives a settled pixel the samples at its corners. */
    private void addCorners(int pixel) {
        int corner = pixel / tile.width() * (tile.width() + 1) + pixel % tile.width();
        for (int i : new int[] {corner, corner + 1, corner + tile.width() + 1, corner + tile.width() + 2}) {
            means.add(corners, i, pixel);
        }
    }

    private void add(int pixel, int samples) {
        queue.add(pixel, tile.column(pixel), tile.row(pixel), samples, 0);
    }
}
