package raytracer.render;

import java.util.concurrent.atomic.AtomicLong;

/** The squares into which a region is cut, row by row from its top left corner; threads take one after the other. */
final class Tiles {

    private final Region region;
    private final int side;
    private final long across;
    private final long count;
    private final AtomicLong next = new AtomicLong();

    /** @param side of a tile, in pixels */
    Tiles(Region region, int side) {
        this.region = region;
        this.side = side;
        across = along(region.width());
        count = across * along(region.height());
    }

    private long along(int pixels) {
        return (pixels + side - 1L) / side;
    }

    Region region() {
        return region;
    }

    long count() {
        return count;
    }

    /** The next tile that nobody has; {@code count} or more if there is none. */
    long next() {
        return next.getAndIncrement();
    }

    int left(long tile) {
        return region.x() + (int) (tile % across) * side;
    }

    int top(long tile) {
        return region.y() + (int) (tile / across) * side;
    }

    int columns(long tile) {
        return Math.min(side, region.x() + region.width() - left(tile));
    }

    int rows(long tile) {
        return Math.min(side, region.y() + region.height() - top(tile));
    }

    int pixels(long tile) {
        return columns(tile) * rows(tile);
    }
}
