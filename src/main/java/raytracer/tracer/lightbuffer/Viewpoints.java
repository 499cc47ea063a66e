package raytracer.tracer.lightbuffer;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Progress;

/** The lights of a scene, from which its light buffers look, and what all of them share while they are built. */
public final class Viewpoints {

    private final List<LightSource> lights;

    /** Of the picture. */
    final Progress progress;

    /** How many primitives have been sorted into any buffer. */
    final AtomicLong sorted = new AtomicLong();

    /** Whether any buffer is being built: one at a time, or each would count on the same memory. */
    final AtomicBoolean isBuilding = new AtomicBoolean();

    public Viewpoints(List<LightSource> lights, Progress progress) {
        this.lights = lights;
        this.progress = progress;
    }

    /** The buffers over a tree by their light, which are told apart as objects. */
    public Map<LightSource, LazyLightBuffer> buffers(Bvh bvh, BoundingShapes shapes) {
        Map<LightSource, LazyLightBuffer> buffers = new IdentityHashMap<>();
        for (LightSource light : lights) {
            buffers.put(light, new LazyLightBuffer(bvh, shapes, light, this));
        }
        return buffers;
    }
}
