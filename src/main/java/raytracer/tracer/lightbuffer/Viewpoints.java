package raytracer.tracer.lightbuffer;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Progress;

/** From where the light buffers of a scene look, and what all of them share while they are built. */
public final class Viewpoints {

    private final List<Viewpoint> viewpoints;

    /** Of the picture. */
    final Progress progress;

    /** How many primitives have been sorted into any buffer. */
    final AtomicLong sorted = new AtomicLong();

    /** Whether any buffer is being built: one at a time, or each would count on the same memory. */
    final AtomicBoolean isBuilding = new AtomicBoolean();

    public Viewpoints(List<Viewpoint> viewpoints, Progress progress) {
        this.viewpoints = viewpoints;
        this.progress = progress;
    }

    /** The buffers over a tree by their source, which are told apart as objects. */
    public Map<LightSource, LazyLightBuffer> buffers(Bvh bvh, BoundingShapes shapes) {
        Map<LightSource, LazyLightBuffer> buffers = new IdentityHashMap<>();
        for (Viewpoint viewpoint : viewpoints) {
            buffers.put(viewpoint.source(), new LazyLightBuffer(bvh, shapes, viewpoint, this));
        }
        return buffers;
    }
}
