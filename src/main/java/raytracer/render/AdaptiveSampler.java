package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
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

    private int left;
    private int top;
    private int columns;
    private PixelMeans means;

    AdaptiveSampler(TileTracer tracer, double error, SampleBudget.Chosen budget) {
        this.tracer = tracer;
        this.error = error;
        this.budget = budget;
        queue = new SampleQueue(tracer);
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        this.left = left;
        this.top = top;
        this.columns = columns;
        means = new PixelMeans(columns * rows);
        queue.start(means);
        boolean[] settled = tracer.traceCorners(left, top, columns, rows, error, corners);
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
        means.send(left, top, columns, rows, sink);
    }

    /** Gives a settled pixel the samples at its corners. */
    private void addCorners(int pixel) {
        int corner = pixel / columns * (columns + 1) + pixel % columns;
        means.add(corners, corner, pixel);
        means.add(corners, corner + 1, pixel);
        means.add(corners, corner + columns + 1, pixel);
        means.add(corners, corner + columns + 2, pixel);
    }

    private void add(int pixel, int samples) {
        queue.add(pixel, left + pixel % columns, top + pixel / columns, samples, 0);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
