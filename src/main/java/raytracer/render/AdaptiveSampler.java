package raytracer.render;

import java.util.List;
import java.util.stream.IntStream;
import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;
import raytracer.tracer.rays.Samples;

/**
 * Spends samples where a pixel is not settled. The first are at the pixels' corners; a pixel of which it is proved that
 * its corners show all there is in it is settled. All others get a closer look; by how much those samples differ
 * decides whether they will do or how many more the pixel gets ({@link SampleBudget}).
 */
final class AdaptiveSampler implements Sampler {

    /** Pixels along a tile's side: their corners are traced together. */
    static final int TILE_SIDE = Tracer.TILE_SIDE - 1;

    /** The samples of each pixel at corners. */
    static final double FIRST_SAMPLES = (double) Samples.CAPACITY / (TILE_SIDE * TILE_SIDE);

    /** Samples of the pixels that only tell what the picture is like: at a glance, and to judge that by. */
    static final int GLANCE = 4;
    private static final int PILOT = 16;

    private final TileTracer tracer;
    private final double error;
    private final SampleBudget budget;
    private final Samples corners = new Samples();
    private final Points points = new Points();

    private int left;
    private int top;
    private int columns;
    private boolean[] settled;
    private PixelMeans means;

    /** @param budget null if this is only to measure variances */
    AdaptiveSampler(TileTracer tracer, double error, SampleBudget budget) {
        this.tracer = tracer;
        this.error = error;
        this.budget = budget;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        look(left, top, columns, rows, budget.closer());
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (!settled[pixel]) {
                add(pixel, budget.samples(means.variance(pixel)) - budget.closer());
            }
        }
        points.trace(tracer, means);
        means.send(left, top, columns, rows, sink);
    }

    /** What those of a rectangle's pixels are like that are not settled. */
    List<SampleBudget.Pilot> pilots(int left, int top, int columns, int rows) {
        look(left, top, columns, rows, GLANCE);
        PixelMeans atAGlance = means;
        means = new PixelMeans(columns * rows);
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (!settled[pixel]) {
                add(pixel, PILOT);
            }
        }
        points.trace(tracer, means);
        return IntStream.range(0, settled.length).filter(pixel -> !settled[pixel])
                .mapToObj(pixel -> new SampleBudget.Pilot(atAGlance.variance(pixel), means.variance(pixel),
                        means.squaredDifference(atAGlance, pixel))).toList();
    }

    /** Takes samples at corners, which are those of settled pixels, and a closer look at all other pixels. */
    private void look(int left, int top, int columns, int rows, int closer) {
        this.left = left;
        this.top = top;
        this.columns = columns;
        means = new PixelMeans(columns * rows);
        settled = tracer.traceCorners(left, top, columns, rows, error, corners);
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (settled[pixel]) {
                addCorners(pixel);
            } else {
                add(pixel, closer);
            }
        }
        points.trace(tracer, means);
    }

    private void addCorners(int pixel) {
        int corner = pixel / columns * (columns + 1) + pixel % columns;
        means.add(corners, corner, pixel);
        means.add(corners, corner + 1, pixel);
        means.add(corners, corner + columns + 1, pixel);
        means.add(corners, corner + columns + 2, pixel);
    }

    private void add(int pixel, int samples) {
        points.add(pixel, left + pixel % columns, top + pixel / columns, samples, 0);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
