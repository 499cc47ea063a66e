package raytracer.tracer.rays;

/** Takes surfaces that a ray hits, in any order. */
public interface Candidates {

    /** @param error bounds that of the distance */
    void add(int surface, double distance, double error);
}
