package raytracer.render;

import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.Tracer;

/** The squares into which a region is cut, row by row from its top left corner; threads take one after the other. */
final class Tiles {

    private final Region region;
    private final long across;
    private final long count;
    private final AtomicLong next = new AtomicLong();

    Tiles(Region region) {
        this.region = region;
        across = along(region.width());
        count = across * along(region.height());
    }

    private static long along(int pixels) {
        return (pixels + Tracer.TILE_SIDE - 1L) / Tracer.TILE_SIDE;
    }

    Region region() {
        return region;
    }

    long count() {
        return count;
    }

    /** Of all tiles. */
    long pixels() {
        return (long) region.width() * region.height();
    }

    /** The next tile that nobody has; {@code count} or more if there is none. */
    long next(int stride) {
        return next.getAndAdd(stride);
    }

    int left(long tile) {
        return region.x() + (int) (tile % across) * Tracer.TILE_SIDE;
    }

    int top(long tile) {
        return region.y() + (int) (tile / across) * Tracer.TILE_SIDE;
    }

    int columns(long tile) {
        return Math.min(Tracer.TILE_SIDE, region.x() + region.width() - left(tile));
    }

    int rows(long tile) {
        return Math.min(Tracer.TILE_SIDE, region.y() + region.height() - top(tile));
    }

    int pixels(long tile) {
        return columns(tile) * rows(tile);
    }
}
