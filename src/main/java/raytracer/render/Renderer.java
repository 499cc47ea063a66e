package raytracer.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import raytracer.image.Image;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;

/**
 * Renders a picture in tiles, from the top down, on a fixed number of threads. Each takes the next tile that nobody
 * has; a pixel does not depend on who traces it, so neither do the bytes.
 */
public final class Renderer {

    private final Tracer tracer;
    private final int threads;
    private final Image image;
    private final int columns;
    private final int tiles;
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicInteger done = new AtomicInteger();

    /** Good for one rendering of the scene that the tracer was made for, into an image of its size. */
    public Renderer(Tracer tracer, int threads, Image image) {
        this.tracer = tracer;
        this.threads = threads;
        this.image = image;
        columns = tilesAlong(image.width());
        tiles = Math.multiplyExact(columns, tilesAlong(image.height()));
    }

    private static int tilesAlong(int pixels) {
        return (int) ((pixels + Tracer.TILE_SIDE - 1L) / Tracer.TILE_SIDE);
    }

    /** Renders the whole picture; returns when it is done. */
    public RayCounts render() {
        ExecutorService pool = Executors.newFixedThreadPool(threads, Renderer::daemon);
        try {
            List<Future<RayCounts>> workers = new ArrayList<>();
            for (int i = 0; i < threads; i++) {
                workers.add(pool.submit(this::work));
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
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while rendering", e);
        } finally {
            pool.shutdownNow();
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
        return (double) done.get() / tiles;
    }

    private RayCounts work() {
        TileTracer tileTracer = tracer.newTileTracer();
        for (int tile; (tile = next.getAndIncrement()) < tiles; ) {
            int left = tile % columns * Tracer.TILE_SIDE;
            int top = tile / columns * Tracer.TILE_SIDE;
            tileTracer.trace(left, top, Math.min(Tracer.TILE_SIDE, image.width() - left),
                    Math.min(Tracer.TILE_SIDE, image.height() - top), image::set);
            done.incrementAndGet();
        }
        return tileTracer.counts();
    }
}
