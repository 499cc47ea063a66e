package raytracer.tracer.surface;

import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;

/** Surfaces without end: few, and hit by nearly every ray, so every ray tries each. */
public interface UnboundedSurfaces extends Surfaces {

    /** Records for rays, from one index to another, the nearest that each hits among these. */
    void intersect(Rays rays, int from, int to);

    /** Occludes every shadow ray, from one index to another, that one of these blocks between its ends. */
    void block(Rays rays, ShadowRays shadows, int from, int to);

    /** Whether one of these blocks each of some shadow rays. */
    boolean anyBlocksAll(Rays rays, ShadowRays shadows, int[] which);
}
