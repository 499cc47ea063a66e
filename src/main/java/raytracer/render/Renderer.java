package raytracer.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/**
 * Renders a picture, or a part of one, in tiles from the top down on a fixed number of threads. Each takes the next
 * tile that nobody has; a pixel does not depend on who traces it, nor on what else is rendered, so neither do the
 * bytes.
 */
public final class Renderer {

    /**
     * To know how many samples an adaptive picture takes, one tile in so many is looked at; more of a small picture, so
     * that there are enough, and fewer of a huge one.
     */
    private static final int PILOT_STRIDE = 8;
    private static final int MIN_PILOTS = 64;
    private static final int MAX_PILOTS = 4096;

    private final Tracer tracer;
    private final Sampling sampling;
    private final int threads;
    private final Tiles tiles;
    private final PixelSink sink;
    private final AtomicLong done = new AtomicLong();

    /**
     * Good for one rendering.
     *
     * @param sink gets the pixels, counted from the region's corner
     */
    public Renderer(Tracer tracer, Sampling sampling, int threads, Region region, PixelSink sink) {
        this.tracer = tracer;
        this.sampling = sampling;
        this.threads = threads;
        this.sink = sink;
        tiles = new Tiles(region);
    }

    /** Renders all of the region; returns when it is done. */
    public RayCounts render() {
        ExecutorService pool = Executors.newFixedThreadPool(threads, Renderer::daemon);
        try {
            if (sampling instanceof Sampling.Adaptive adaptive) {
                return renderAdaptively(adaptive.error(), pool);
            }
            tracer.expect(tiles.pixels() * sampling.samples());
            return onAllThreads(pool, () -> work(newSampler()));
        } finally {
            pool.shutdownNow();
        }
    }

    private Sampler newSampler() {
        return sampling instanceof Sampling.Grid grid
                ? newGridSampler(grid.n())
                : new SequenceSampler(tracer.newTileTracer(), (Sampling.Sequence) sampling);
    }

    private Sampler newGridSampler(int n) {
        return n == 1 ? new CentreSampler(tracer.newTileTracer()) : new GridSampler(tracer.enlarged(n).newTileTracer(), n);
    }

    private RayCounts renderAdaptively(double error, ExecutorService pool) {
        // Of the whole picture, so that a part of it gets the same samples.
        Tiles whole = new Tiles(Region.whole(tracer.width(), tracer.height()));
        int stride = (int) Math.max(Math.max(1, whole.count() / MAX_PILOTS),
                Math.min(PILOT_STRIDE, whole.count() / MIN_PILOTS));
        double[][] variances = new double[(int) ((whole.count() + stride - 1) / stride)][];
        RayCounts pilot = onAllThreads(pool,
                () -> look(new AdaptiveSampler(tracer.newTileTracer(), error, null), whole, stride, variances));
        long pixels = 0;
        for (int i = 0; i < variances.length; i++) {
            pixels += whole.pixels((long) i * stride);
        }
        double[] all = Arrays.stream(variances).flatMapToDouble(Arrays::stream).toArray();
        tracer.expect((long) (tiles.pixels() * AdaptiveSampler.firstSamples(error)));
        SampleBudget budget = SampleBudget.plan(all, pixels, error, AdaptiveSampler.firstSamples(error));
        return pilot.plus(onAllThreads(pool, () -> work(budget.grid() > 0
                ? newGridSampler(budget.grid())
                : new AdaptiveSampler(tracer.newTileTracer(), error, budget))));
    }

    private RayCounts onAllThreads(ExecutorService pool, Callable<RayCounts> work) {
        try {
            List<Future<RayCounts>> workers = new ArrayList<>();
            for (int i = 0; i < threads; i++) {
                workers.add(pool.submit(work));
            }
            RayCounts total = RayCounts.ZERO;
            for (Future<RayCounts> worker : workers) {
                total = total.plus(worker.get());
            }
            return total;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            if (e.getCause() instanceof RuntimeException exception) {
                throw exception;
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while rendering", e);
        }
    }

    /** A thread that does not keep the program alive when the main thread has failed. */
    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "tracer");
        thread.setDaemon(true);
        return thread;
    }

    /** How much of the picture is done, from 0 to 1; any thread may ask. */
    public double progress() {
        return (double) done.get() / tiles.count();
    }

    /** Measures the variances of every so many-th tile. */
    private static RayCounts look(AdaptiveSampler sampler, Tiles whole, int stride, double[][] variances) {
        for (long tile; (tile = whole.next(stride)) < whole.count(); ) {
            variances[(int) (tile / stride)] = sampler.variances(
                    whole.left(tile), whole.top(tile), whole.columns(tile), whole.rows(tile));
        }
        return sampler.counts();
    }

    /** Counts pixels from a region's corner. */
    private record InRegion(Region region, PixelSink sink) implements PixelSink {
        @Override
        public void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
            sink.setPixels(x - region.x(), y - region.y(), columns, rows, red, green, blue);
        }
    }

    private RayCounts work(Sampler sampler) {
        PixelSink inRegion = new InRegion(tiles.region(), sink);
        for (long tile; (tile = tiles.next(1)) < tiles.count(); ) {
            sampler.render(tiles.left(tile), tiles.top(tile), tiles.columns(tile), tiles.rows(tile), inRegion);
            done.incrementAndGet();
        }
        return sampler.counts();
    }
}
