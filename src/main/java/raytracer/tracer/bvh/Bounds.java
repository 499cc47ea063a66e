package raytracer.tracer.bvh;

/** The axis-aligned boxes of numbered primitives. */
@FunctionalInterface
public interface Bounds {

    /** Writes the box of primitive k: least x, y, z, then greatest x, y, z. */
    void of(int k, double[] box);
}
