package raytracer.tracer.arithmetic;

/** How many rays are traced together. */
public final class Batch {

    /**
     * Pixels of a tile's side. More rays would share what a tile costs whatever its size; but the quantities that a loop
     * needs, each 3 KB for so many, are still in the L1 cache.
     */
    public static final int SIDE = 20;

    public static final int CAPACITY = SIDE * SIDE;

    private Batch() { }
}
