package raytracer.tracer.surface;

import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.Rays;

/**
 * All surfaces of one kind. Each has an index, a number that is its own among all kinds; what is known of it by index
 * lies in arrays. A scene without a kind has no object for it, and so no code of it runs.
 */
public interface Surfaces {

    /** Adds all of these that a ray hits no farther away than {@link Rays#maxDistance}. */
    void collect(Rays rays, int ray, Candidates candidates, Workspace workspace);

    /** Whether the surface with this index is one of these. */
    boolean owns(int surface);

    /**
     * Moves rays, from one index to another, that have hit these to where they hit them: their origins become those
     * points, with bounds on their errors, and the normals are set.
     */
    void moveToHits(Rays rays, int from, int to, Workspace workspace);
}
