package raytracer.tracer;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A {@link LightBuffer} that is built as soon as the walks through the tree that it would have spared have taken as
 * long as it takes to build: so however many are still to come, at most twice the time is taken that hindsight would
 * (the ski rental problem; Karlin et al., Competitive Snoopy Caching, 1988). Pixels do not depend on when it is.
 * Threads share it.
 */
final class LazyLightBuffer {

    /** It takes as long to build as so many walks for each thing: about as long as a walk that is spared. */
    private static final int WALKS = 1;

    /** And as so many more because the code that builds it is cold. */
    private static final int COLD_WALKS = 250_000;

    /** The most things times lamps, with the eye: more could take more than 370 MB, though 200 are usual. */
    private static final long MOST_THINGS = 1 << 22;

    private final Bvh bvh;
    private final Hulls hulls;
    private final Lamp lamp;
    private final long due;
    private final AtomicLong walks = new AtomicLong();
    private volatile LightBuffer buffer;

    private LazyLightBuffer(Bvh bvh, Hulls hulls, Lamp lamp) {
        this.bvh = bvh;
        this.hulls = hulls;
        this.lamp = lamp;
        due = COLD_WALKS + WALKS * (long) bvh.order().length;
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
            long before = walks.getAndAdd(rays);
            // For one thread only.
            if (before < due && before + rays >= due && hasRoom()) {
                buffer = LightBufferBuilder.build(bvh, hulls, lamp);
            }
        }
        return buffer;
    }
}
