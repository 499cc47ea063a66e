package raytracer.render;

import java.util.Arrays;
import java.util.Collections;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;

/**
 * Renders a picture, or a part of one, in tiles from the top down on a fixed number of threads. Each takes the next
 * tile that nobody has; a pixel does not depend on who traces it, nor on what else is rendered, so neither do the
 * bytes.
 */
public final class Renderer {

    private final Tracer tracer;
    private final Sampling sampling;
    private final int threads;
    private final Region region;
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
        this.region = region;
        tiles = sampling instanceof Sampling.Adaptive
                ? new Tiles(region.aligned(AdaptiveSampler.TILE_SIDE, tracer.width(), tracer.height()),
                        AdaptiveSampler.TILE_SIDE)
                : new Tiles(region, Tracer.TILE_SIDE);
    }

    /** Renders all of the region; returns when it is done. */
    public RayCounts render() {
        ExecutorService pool = Executors.newFixedThreadPool(threads, Renderer::daemon);
        try {
            if (sampling instanceof Sampling.Adaptive adaptive) {
                return renderAdaptively(adaptive.error(), pool);
            }
            Tracer enlarged = sampling instanceof Sampling.Grid grid ? tracer.enlarged(grid.n()) : tracer;
            return onAllThreads(pool, () -> work(enlarged, this::newSampler));
        } finally {
            pool.shutdownNow();
        }
    }

    private Sampler newSampler(TileTracer mine) {
        return sampling instanceof Sampling.Grid grid ? new GridSampler(mine, grid.n())
                : new LatticeSampler(mine, (Sampling.Lattice) sampling);
    }

    private RayCounts renderAdaptively(double error, ExecutorService pool) {
        Pilots pilots = new Pilots(tracer, error);
        RayCounts before = RayCounts.ZERO;
        SampleBudget guess;
        do {
            pilots.startRound();
            before = before.plus(onAllThreads(pool, pilots::sample));
            guess = pilots.budget();
        } while (pilots.areCoarse(guess));
        if (guess.all() == 0) {
            before = before.plus(onAllThreads(pool, pilots::prove));
        }
        SampleBudget budget = guess.all() > 0 ? guess : pilots.budget();
        return before.plus(onAllThreads(pool, () -> work(tracer, mine -> budget.all() > 0
                ? new LatticeSampler(mine, new Sampling.Lattice(budget.all(), 0))
                : new AdaptiveSampler(mine, error, budget.chosen()))));
    }

    private RayCounts onAllThreads(ExecutorService pool, Callable<RayCounts> work) {
        try {
            RayCounts total = RayCounts.ZERO;
            for (Future<RayCounts> worker : pool.invokeAll(Collections.nCopies(threads, work))) {
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

    /** Counts pixels from a region's corner, and drops those outside. */
    private record InRegion(Region region, PixelSink sink) implements PixelSink {
        @Override
        public void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
            int left = Math.max(x, region.x()), right = Math.min(x + columns, region.x() + region.width());
            for (int row = Math.max(y, region.y()); row < Math.min(y + rows, region.y() + region.height()); row++) {
                int from = (row - y) * columns + left - x, to = (row - y) * columns + right - x;
                sink.setPixels(left - region.x(), row - region.y(), right - left, 1,
                        Arrays.copyOfRange(red, from, to), Arrays.copyOfRange(green, from, to),
                        Arrays.copyOfRange(blue, from, to));
            }
        }
    }

    private RayCounts work(Tracer of, Function<TileTracer, Sampler> newSampler) {
        TileTracer mine = of.newTileTracer();
        Sampler sampler = newSampler.apply(mine);
        PixelSink inRegion = new InRegion(region, sink);
        for (long tile; (tile = tiles.next()) < tiles.count(); ) {
            sampler.render(tiles.get(tile), inRegion);
            done.incrementAndGet();
        }
        return mine.counts();
    }
}
