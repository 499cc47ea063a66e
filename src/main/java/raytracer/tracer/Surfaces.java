package raytracer.tracer;

/**
 * All surfaces of one kind. Each has a slot, a number that is its own among all kinds; what is known of it by slot lies
 * in arrays. A scene without a kind has no object for it, and so no code of it runs.
 */
sealed interface Surfaces permits Planes, BoundedSurfaces {

    /**
     * What offers every ray what it meets among these: {@link Rays#offer}.
     *
     * @param eye where rays start, if they leave the eye
     */
    Pass finding(Rays rays, Lamp eye, Scratch scratch);

    /** Bounds the error of the distance at which a ray meets the surface in a slot. */
    double distanceError(Rays rays, int ray, int slot, double t);

    /** What closes every open shadow ray that one of these blocks between its ends. */
    Pass blocking(Rays rays, ShadowRays shadows, Scratch scratch);

    /** Whether a slot is one of these. */
    boolean owns(int slot);

    /** Whether all that have one look are parts of one surface, as triangles are of a mesh. */
    boolean isOfOneSurface();

    /**
     * Takes rays, from one index to another, that have met these to where they met them: their origins become those
     * points, with bounds on their errors, and the normals are set.
     */
    void arrive(Rays rays, int from, int to, Scratch scratch);
}
