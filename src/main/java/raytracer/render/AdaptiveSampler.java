package raytracer.render;

import java.util.stream.IntStream;
import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;

/**
 * Spends samples where a pixel is not settled. A first pass takes a few samples of every pixel and of those around; a
 * pixel whose neighbourhood shows the same surfaces in the same light by way of the same mirrors, in colours that
 * change evenly, is settled. All others get a closer look; by how much its samples differ decides whether they will
 * do or how many the pixel gets in their place ({@link SampleBudget}).
 */
final class AdaptiveSampler implements Sampler {

    /** Aims below this need more samples to start from: what falls between them stays unseen. */
    private static final double FINE = 1 / 400.0;

    /** Of the aim: by how much a pixel's colour may be off the mean of two opposite neighbours'. */
    private static final double UNEVENNESS = 4;

    /** Samples along a pixel's side in the closer look of those that only tell what the picture is like. */
    private static final int PILOT = 3;

    private final TileTracer tracer;
    private final double unevenness;
    /** Samples along a pixel's side in the first pass. */
    private final int first;
    private final SampleBudget budget;
    private final Samples samples;
    private final Points points = new Points();

    private int columns;
    private int rows;
    /** By pixel of the rectangle with a rim of one pixel. */
    private PixelMeans means;

    /** @param budget null if this is only to measure variances */
    AdaptiveSampler(TileTracer tracer, double error, SampleBudget budget) {
        this.tracer = tracer;
        this.budget = budget;
        unevenness = UNEVENNESS * error;
        samples = Samples.ofColourAndPath(unevenness);
        first = error < FINE ? 2 : 1;
    }

    /** The samples of each pixel in the first pass, with its share of those of the rims. */
    static double firstSamples(double error) {
        double side = Tracer.TILE_SIDE, rimmed = side + 2;
        return (error < FINE ? 4 : 1) * rimmed * rimmed / (side * side);
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        boolean[] settled = look(left, top, columns, rows, budget.closer());
        addMore(left, top, settled);
        take();
        send(left, top, sink);
    }

    // As in Points, loops over pixels are kept apart from the tracer, for HotSpot's sake.

    private void addMore(int left, int top, boolean[] settled) {
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (isInside(pixel) && !settled[pixel]) {
                int n = budget.along(means.variance(pixel));
                if (n > budget.closer()) {
                    means.clear(pixel);
                    addGrid(left, top, pixel, n);
                }
            }
        }
    }

    private void send(int left, int top, PixelSink sink) {
        for (int row = 1; row < rows - 1; row++) {
            means.send(row * columns + 1, left, top + row - 1, columns - 2, 1, sink);
        }
    }

    /** The variances within those of a rectangle's pixels that are not settled. */
    double[] variances(int left, int top, int columns, int rows) {
        boolean[] settled = look(left, top, columns, rows, PILOT);
        return IntStream.range(0, settled.length).filter(pixel -> isInside(pixel) && !settled[pixel])
                .mapToDouble(pixel -> means.variance(pixel)).toArray();
    }

    /** Takes the first samples, and a closer look at pixels that are not settled; returns which are. */
    private boolean[] look(int left, int top, int columns, int rows, int closer) {
        this.columns = columns + 2;
        this.rows = rows + 2;
        int pixels = this.columns * this.rows;
        means = new PixelMeans(pixels);
        addFirst(left, top, pixels);
        take();
        boolean[] settled = settled(pixels);
        addCloser(left, top, settled, closer);
        take();
        return settled;
    }

    private void addFirst(int left, int top, int pixels) {
        for (int pixel = 0; pixel < pixels; pixel++) {
            addGrid(left, top, pixel, first);
        }
    }

    private boolean[] settled(int pixels) {
        boolean[] settled = new boolean[pixels];
        for (int pixel = 0; pixel < pixels; pixel++) {
            settled[pixel] = isInside(pixel) && isSettled(pixel);
        }
        return settled;
    }

    private void addCloser(int left, int top, boolean[] settled, int closer) {
        for (int pixel = 0; pixel < settled.length; pixel++) {
            if (isInside(pixel) && !settled[pixel]) {
                means.clear(pixel);
                addGrid(left, top, pixel, closer);
            }
        }
    }

    private boolean isInside(int pixel) {
        int column = pixel % columns, row = pixel / columns;
        return column > 0 && column < columns - 1 && row > 0 && row < rows - 1;
    }

    private int x(int left, int pixel) {
        return left - 1 + pixel % columns;
    }

    private int y(int top, int pixel) {
        return top - 1 + pixel / columns;
    }

    private boolean isSettled(int pixel) {
        for (int row = -columns; row <= columns; row += columns) {
            for (int neighbour = pixel + row - 1; neighbour <= pixel + row + 1; neighbour++) {
                if (!means.areAlike(pixel, neighbour)) {
                    return false;
                }
            }
        }
        return isEven(pixel, 1) && isEven(pixel, columns) && isEven(pixel, columns + 1) && isEven(pixel, columns - 1);
    }

    /** Whether a pixel's colour is about the mean of two opposite neighbours'. */
    private boolean isEven(int p, int step) {
        int a = p - step, b = p + step;
        return Math.abs(means.red(a) - 2 * means.red(p) + means.red(b)) <= unevenness
                && Math.abs(means.green(a) - 2 * means.green(p) + means.green(b)) <= unevenness
                && Math.abs(means.blue(a) - 2 * means.blue(p) + means.blue(b)) <= unevenness;
    }

    private void addGrid(int left, int top, int pixel, int n) {
        points.addGrid(pixel, x(left, pixel), y(top, pixel), n);
    }

    private void take() {
        points.trace(tracer, samples, means);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
