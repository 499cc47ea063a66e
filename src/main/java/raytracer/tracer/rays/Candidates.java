package raytracer.tracer.rays;

/** Takes surfaces that a ray meets, in any order. */
public interface Candidates {

    /** @param error bounds that of the distance */
    void add(int slot, double distance, double error);
}
