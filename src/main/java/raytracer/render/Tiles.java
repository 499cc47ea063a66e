package raytracer.render;

import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.Tracer;

/**
 * The parts into which a region is cut, row by row from its top left corner; threads take one after the other. They are
 * squares, but longer where the region is narrower than a square's side, so that as many pixels are traced together.
 *
 * @param columns of a tile
 * @param rows    of a tile
 */
record Tiles(Region region, int columns, int rows, AtomicLong next) {

    /** The most pixels of a tile. */
    static final int CAPACITY = Tracer.TILE_SIDE * Tracer.TILE_SIDE;

    static Tiles of(Region region) {
        int columns = region.height() < Tracer.TILE_SIDE ? CAPACITY / region.height() : Tracer.TILE_SIDE;
        int rows = region.width() < Tracer.TILE_SIDE ? CAPACITY / region.width() : Tracer.TILE_SIDE;
        return new Tiles(region, columns, rows, new AtomicLong());
    }

    private long across() {
        return (region.width() + columns - 1L) / columns;
    }

    long count() {
        return across() * ((region.height() + rows - 1L) / rows);
    }

    /** The next tile that nobody has; {@code count} or more if there is none. */
    long take() {
        return next.getAndIncrement();
    }

    Region get(long tile) {
        int left = columns * (int) (tile % across()), top = rows * (int) (tile / across());
        return new Region(region.x() + left, region.y() + top, Math.min(columns, region.width() - left),
                Math.min(rows, region.height() - top));
    }
}
