package raytracer.tracer;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A {@link LightBuffer} that is built as soon as the walks through the tree that it would have spared have taken as
 * long as it takes to build: so however many are still to come, at most twice the time is taken that hindsight would
 * (the ski rental problem; Karlin et al., Competitive Snoopy Caching, 1988). Pixels do not depend on when it is.
 * Threads share it.
 */
final class LazyLightBuffer {

    /**
     * It takes about as long to build as a walk for each thing, and as so many more while the code that builds it is
     * cold: one fewer for each thing that it has sorted.
     */
    private static final int COLD_WALKS = 250_000;

    /** By any buffer: HotSpot too counts for the whole process. */
    private static final AtomicLong SORTED = new AtomicLong();

    /** The most things times lamps, with the eye: more could take more than 370 MB, though 200 are usual. */
    private static final long MOST_THINGS = 1 << 22;

    private final Bvh bvh;
    private final Hulls hulls;
    private final Lamp lamp;
    private final AtomicLong walks = new AtomicLong();
    private final AtomicBoolean begun = new AtomicBoolean();
    private volatile LightBuffer buffer;

    private LazyLightBuffer(Bvh bvh, Hulls hulls, Lamp lamp) {
        this.bvh = bvh;
        this.hulls = hulls;
        this.lamp = lamp;
    }

    /** By lamp, which are told apart as objects; of none if there is not the memory for it. */
    static Map<Lamp, LazyLightBuffer> of(List<Lamp> lamps, Bvh bvh, Hulls hulls) {
        Map<Lamp, LazyLightBuffer> buffers = new IdentityHashMap<>();
        if ((long) lamps.size() * bvh.order().length <= MOST_THINGS) {
            for (Lamp lamp : lamps) {
                buffers.put(lamp, new LazyLightBuffer(bvh, hulls, lamp));
            }
        }
        return buffers;
    }

    /** Whether there is memory for it, and for another built meanwhile: it is worth some time, but no failure. */
    private boolean hasRoom() {
        Runtime java = Runtime.getRuntime();
        long free = java.maxMemory() - java.totalMemory() + java.freeMemory();
        return free > 2 * LightBufferBuilder.MOST_BYTES * bvh.order().length;
    }

    /** The buffer; null if it is not there. */
    LightBuffer ifBuilt() {
        return buffer;
    }

    /** The buffer, to use instead of so many walks; null if it is not there. */
    LightBuffer insteadOfWalks(int rays) {
        if (buffer == null) {
            long due = bvh.order().length + Math.max(0, COLD_WALKS - SORTED.get());
            if (walks.addAndGet(rays) >= due && begun.compareAndSet(false, true) && hasRoom()) {
                buffer = LightBufferBuilder.build(bvh, hulls, lamp);
                SORTED.addAndGet(bvh.order().length);
            }
        }
        return buffer;
    }
}
