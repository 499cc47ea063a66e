package raytracer.tracer.kernel;

/**
 * Work on all of a batch's numbers from one index up to before another.
 *
 * <p>Kernels are objects that know their arrays, and are run by way of {@link #run(Kernel, int, int)}, so that each kind
 * is compiled once. Were they methods, HotSpot's C2 would copy them into every method on the way there, some several
 * times over, and be busy for seconds.
 */
public interface Kernel {

    void run(int from, int to);

    /** Runs a kernel of a kind that HotSpot does not know, even in a method that has just made it. */
    static void run(Kernel kernel, int from, int to) {
        unknown(kernel, 2).run(from, to);
    }

    /**
     * HotSpot inlines recursion one level deep (-XX:MaxRecursiveInlineLevel), so two levels hide the receiver's type.
     */
    private static Kernel unknown(Kernel kernel, int deeper) {
        return deeper > 0 ? unknown(kernel, deeper - 1) : kernel;
    }
}
