package raytracer.tracer;

/** Takes surfaces that a ray meets, in any order. */
interface Candidates {

    /** @param error bounds that of the distance */
    void add(int slot, double distance, double error);
}
