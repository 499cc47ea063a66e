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

    long count() {
        return count;
    }

    /** The next tile that nobody has; {@code count} or more if there is none. */
    long next() {
        return next.getAndIncrement();
    }

    Region get(long tile) {
        int left = region.x() + (int) (tile % across) * side, top = region.y() + (int) (tile / across) * side;
        return new Region(left, top, Math.min(side, region.x() + region.width() - left),
                Math.min(side, region.y() + region.height() - top));
    }
}
