package raytracer.tracer.surface;

import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;

/** Surfaces without end: few, and hit by nearly every ray, so every ray tries each. */
public interface UnboundedSurfaces extends Surfaces {

    /** What records for every ray the nearest that it hits among these. */
    Kernel intersecting(Rays rays);

    /** What occludes every shadow ray that one of these blocks between its ends. */
    Kernel blocking(Rays rays, ShadowRays shadows);

    /** Whether one of these blocks each of some shadow rays. */
    boolean anyBlocksAll(Rays rays, ShadowRays shadows, int[] which);
}
