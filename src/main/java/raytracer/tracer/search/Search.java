package raytracer.tracer.search;

/** Finds what a batch's rays hit of one kind of surfaces. */
@FunctionalInterface
public interface Search {

    /** Searches for the rays from one index up to before another. */
    void find(int from, int to);

    /**
     * The same in a way that HotSpot does not inline where some kind has no tree, so that it compiles each kind of search
     * once: it takes two classes of searches, for of the only one it knows what a call runs.
     */
    default void run(int from, int to) {
        unknown(this, 2).find(from, to);
    }

    /** HotSpot inlines recursion one level deep (-XX:MaxRecursiveInlineLevel), so two hide the receiver's type. */
    private static Search unknown(Search search, int deeper) {
        return deeper > 0 ? unknown(search, deeper - 1) : search;
    }
}
