package raytracer.render;

import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.Tracer;

/** The squares into which a region is cut, row by row from its top left corner; threads take one after the other. */
record Tiles(Region region, AtomicLong next) {

    Tiles(Region region) {
        this(region, new AtomicLong());
    }

    private static long along(int pixels) {
        return (pixels + Tracer.TILE_SIDE - 1L) / Tracer.TILE_SIDE;
    }

    long count() {
        return along(region.width()) * along(region.height());
    }

    /** The next tile that nobody has; {@code count} or more if there is none. */
    long take() {
        return next.getAndIncrement();
    }

    Region get(long tile) {
        long across = along(region.width());
        int left = Tracer.TILE_SIDE * (int) (tile % across), top = Tracer.TILE_SIDE * (int) (tile / across);
        return new Region(region.x() + left, region.y() + top, Math.min(Tracer.TILE_SIDE, region.width() - left),
                Math.min(Tracer.TILE_SIDE, region.height() - top));
    }
}
