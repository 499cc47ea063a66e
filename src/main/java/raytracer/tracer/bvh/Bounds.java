package raytracer.tracer.bvh;

/** The axis-aligned boxes of numbered things. */
@FunctionalInterface
public interface Bounds {

    /** Writes the box of thing k: least x, y, z, then greatest x, y, z. */
    void of(int k, double[] box);
}
