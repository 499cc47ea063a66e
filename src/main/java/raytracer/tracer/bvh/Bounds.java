package raytracer.tracer.bvh;

/** The axis-aligned boxes of numbered primitives. */
public interface Bounds {

    /** Writes the box of primitive k: least x, y, z, then greatest x, y, z. */
    void of(int k, double[] box);

    /** Whether two primitives are the same in all that decides hits. */
    boolean areSame(int k, int other);
}
