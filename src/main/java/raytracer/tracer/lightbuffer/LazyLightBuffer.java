package raytracer.tracer.lightbuffer;

import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;

/**
 * A {@link LightBuffer} that is built when it will spare more walks through the tree than it costs: as many are still
 * to come as samples are, in proportion to those so far. Pixels do not depend on when it is. Threads share it.
 */
public final class LazyLightBuffer {

    /** Building costs about one walk a primitive, and so many more at first, until its code is compiled. */
    private static final int COLD_WALKS = 250_000;

    /** Fewer walks than one for so many primitives say little about how many will come. */
    private static final int FEW = 16;

    /** Of the memory that there may be, what is left for all else: one part in so many. */
    private static final int LEFT = 4;

    private final Bvh bvh;
    private final BoundingShapes shapes;
    private final LightSource light;
    private final Viewpoints all;
    private final AtomicLong walks = new AtomicLong();
    private volatile boolean isBegun;
    private volatile LightBuffer buffer;

    LazyLightBuffer(Bvh bvh, BoundingShapes shapes, LightSource light, Viewpoints all) {
        this.bvh = bvh;
        this.shapes = shapes;
        this.light = light;
        this.all = all;
    }

    /** The buffer; null if it is not there. */
    public LightBuffer ifBuilt() {
        return buffer;
    }

    /** The buffer, to use instead of so many walks; null if it is not there. */
    public LightBuffer insteadOfWalks(int rays) {
        if (!isBegun && pays(walks.addAndGet(rays)) && all.isBuilding.compareAndSet(false, true)) {
            try {
                build();
            } finally {
                all.isBuilding.set(false);
            }
        }
        return buffer;
    }

    private boolean pays(long walksSoFar) {
        int primitives = bvh.order().length;
        return walksSoFar >= primitives / FEW
                && all.progress.ahead(walksSoFar) > primitives + Math.max(0, COLD_WALKS - all.sorted.get());
    }

    private void build() {
        if (!isBegun) {
            isBegun = true;
            Runtime java = Runtime.getRuntime();
            if (hasRoom(bvh.order().length, java.maxMemory(), java.totalMemory() - java.freeMemory())) {
                buffer = LightBufferBuilder.build(bvh, shapes, light);
                all.sorted.addAndGet(bvh.order().length);
            }
        }
    }

    /** Whether there is memory to build one of so many primitives: it is worth some time, but no failure. */
    static boolean hasRoom(int primitives, long max, long used) {
        return LightBufferBuilder.MAX_BYTES * primitives < max - used - max / LEFT;
    }
}
