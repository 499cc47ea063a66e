package raytracer.tracer.rays;

import raytracer.scene.Material;

/** Looks on while a batch of {@link Rays} is traced, from the eye and then from mirror to mirror. */
public interface BatchObserver {

    /** All rays have found what they hit, and are still where they started. */
    void found();

    /** Those that hit something have moved there; the others have left. */
    void moved();

    /** The rays from one index to another have shadow rays to a light, unoccluded where it would add something. */
    void aimed(int from, int to, ShadowRays shadows);

    /** Those shadow rays that surfaces block are occluded now. */
    void lit(int from, int to, ShadowRays shadows, Material material);
}
