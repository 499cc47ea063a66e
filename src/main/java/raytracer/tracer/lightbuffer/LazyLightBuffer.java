package raytracer.tracer.lightbuffer;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;

/**
 * A {@link LightBuffer} that is built as soon as the walks through the tree that it would have spared have taken as
 * long as it takes to build: so however many are still to come, at most twice the time is taken that hindsight would
 * (the ski rental problem; Karlin et al., Competitive Snoopy Caching, 1988). Pixels do not depend on when it is.
 * Threads share it.
 */
public final class LazyLightBuffer {

    /** Building costs about one walk a primitive, and so many more at first, until its code is compiled. */
    private static final int COLD_WALKS = 250_000;

    /** By any buffer: HotSpot too counts for the whole process. */
    private static final AtomicLong SORTED = new AtomicLong();

    /** Whether any is being built: one at a time, or each would count on the same memory. */
    private static final AtomicBoolean BUILDING = new AtomicBoolean();

    /** Of the memory that there may be, what is left for all else: one part in so many. */
    private static final int LEFT = 4;

    private final Bvh bvh;
    private final BoundingShapes hulls;
    private final Viewpoint viewpoint;
    private final AtomicLong walks = new AtomicLong();
    private volatile boolean begun;
    private volatile LightBuffer buffer;

    private LazyLightBuffer(Bvh bvh, BoundingShapes hulls, Viewpoint viewpoint) {
        this.bvh = bvh;
        this.hulls = hulls;
        this.viewpoint = viewpoint;
    }

    /** By source, which are told apart as objects. */
    public static Map<LightSource, LazyLightBuffer> of(List<Viewpoint> viewpoints, Bvh bvh, BoundingShapes hulls) {
        Map<LightSource, LazyLightBuffer> buffers = new IdentityHashMap<>();
        for (Viewpoint viewpoint : viewpoints) {
            buffers.put(viewpoint.source(), new LazyLightBuffer(bvh, hulls, viewpoint));
        }
        return buffers;
    }

    private boolean hasRoom() {
        Runtime java = Runtime.getRuntime();
        return hasRoom(bvh.order().length, java.maxMemory(), java.totalMemory() - java.freeMemory());
    }

    /** Whether there is memory to build one of so many primitives: it is worth some time, but no failure. */
    static boolean hasRoom(int primitives, long max, long used) {
        return LightBufferBuilder.MAX_BYTES * primitives < max - used - max / LEFT;
    }

    /** The buffer; null if it is not there. */
    public LightBuffer ifBuilt() {
        return buffer;
    }

    /** The buffer, to use instead of so many walks; null if it is not there. */
    public LightBuffer insteadOfWalks(int rays) {
        if (!begun && walks.addAndGet(rays) >= due() && BUILDING.compareAndSet(false, true)) {
            try {
                build();
            } finally {
                BUILDING.set(false);
            }
        }
        return buffer;
    }

    private long due() {
        return bvh.order().length + Math.max(0, COLD_WALKS - SORTED.get());
    }

    private void build() {
        if (!begun) {
            begun = true;
            if (hasRoom()) {
                buffer = LightBufferBuilder.build(bvh, hulls, viewpoint);
                SORTED.addAndGet(bvh.order().length);
            }
        }
    }
}
