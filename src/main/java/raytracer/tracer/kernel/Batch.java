package raytracer.tracer.kernel;

/** How many rays are traced together. */
public final class Batch {

    /**
     * Pixels of a tile's side. What a tile costs whatever its size is shared by so many rays, and what a kernel needs
     * of them is still in the L1 cache: a quantity is 3 KB.
     */
    public static final int SIDE = 20;

    public static final int CAPACITY = SIDE * SIDE;

    private Batch() { }
}
