package raytracer.tracer;

/**
 * All surfaces of one kind. Each has a slot, a number that is its own among all kinds; what is known of it by slot lies
 * in arrays. A scene without a kind has no object for it, and so no code of it runs.
 */
sealed interface Surfaces permits Planes, BoundedSurfaces {

    /** Offers every ray what it meets among these: {@link Rays#offer}. */
    void findNearest(Rays rays, Scratch scratch);

    /** Bounds the error of the distance at which a ray meets the surface in a slot. */
    double distanceError(Rays rays, int ray, int slot, double t);

    /** Closes every open shadow ray that one of these blocks, strictly between its ends. */
    void block(Rays rays, ShadowRays shadows, Scratch scratch);

    /** Whether a slot is one of these. */
    boolean owns(int slot);

    /**
     * Takes a ray that has met one of these to where it met it: the origin becomes that point, with a bound on its
     * error, and the normal is set.
     */
    void arrive(Rays rays, int ray);
}
