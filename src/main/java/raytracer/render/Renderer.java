package raytracer.render;

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
import raytracer.tracer.rays.Samples;

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
    private volatile int samples = 1;

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
        tiles = Tiles.of(region);
    }

    /** Renders all of the region; returns when it is done. */
    public RayCounts render() {
        ExecutorService pool = Executors.newFixedThreadPool(threads, Renderer::daemon);
        try {
            if (sampling.equals(Sampling.CENTRES)) {
                return onAllThreads(pool, () -> work(tracer, mine -> new CentreSampler(mine, new Samples())));
            }
            if (sampling instanceof Sampling.Grid grid) {
                samples = grid.n() * grid.n();
                Tracer enlarged = tracer.resized(Math.multiplyExact(grid.n(), tracer.width()),
                        Math.multiplyExact(grid.n(), tracer.height()));
                return onAllThreads(pool, () -> work(enlarged, mine -> new PatternSampler(mine, Pattern.grid(grid.n()))));
            }
            if (sampling instanceof Sampling.Lattice lattice) {
                return renderLattice(lattice, pool);
            }
            return renderWithin(((Sampling.Within) sampling).error(), pool);
        } finally {
            pool.shutdownNow();
        }
    }

    private RayCounts renderWithin(double error, ExecutorService pool) {
        Pilots pilots = new Pilots(tracer, error);
        RayCounts before = RayCounts.ZERO;
        do {
            pilots.startRound();
            before = before.plus(onAllThreads(pool, pilots::sample));
        } while (pilots.areCoarse(pilots.samples()));
        return before.plus(renderLattice(new Sampling.Lattice(pilots.samples(), 0), pool));
    }

    /** How many samples each pixel got, once it is rendered; those of pilots, which decide it, are more. */
    public int samples() {
        return samples;
    }

    private RayCounts renderLattice(Sampling.Lattice lattice, ExecutorService pool) {
        samples = lattice.count();
        return onAllThreads(pool, () -> work(tracer,
                mine -> new PatternSampler(mine, Pattern.lattice(lattice.count(), lattice.seed()))));
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

    private RayCounts work(Tracer of, Function<TileTracer, Sampler> newSampler) {
        TileTracer mine = of.newTileTracer();
        Sampler sampler = newSampler.apply(mine);
        PixelSink inRegion = (x, y, columns, rows, red, green, blue) ->
                sink.setPixels(x - region.x(), y - region.y(), columns, rows, red, green, blue);
        for (long tile; (tile = tiles.take()) < tiles.count(); ) {
            sampler.render(tiles.get(tile), inRegion);
            done.incrementAndGet();
        }
        return mine.counts();
    }
}
