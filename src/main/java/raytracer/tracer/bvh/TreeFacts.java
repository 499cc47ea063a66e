package raytracer.tracer.bvh;

/**
 * What is worth telling about a tree.
 *
 * @param kind   of surfaces, in the plural
 * @param primitives how many are in the tree
 * @param oversized how many are beside it, and tried by every ray
 * @param depth  the most nodes on a way from the root to a leaf
 * @param bytes  the memory of its nodes
 */
public record TreeFacts(String kind, int primitives, int oversized, int nodes, int depth, long bytes) {

    public static TreeFacts of(String kind, Bvh bvh) {
        return new TreeFacts(kind, bvh.order().length - bvh.oversized(), bvh.oversized(),
                bvh.nodes().length / Bvh.NODE_STRIDE, depth(bvh, bvh.root()), 4L * bvh.nodes().length);
    }

    private static int depth(Bvh bvh, int node) {
        if (node < 0) {
            return 0;
        }
        int deepest = 0;
        for (int child = 0; child < Bvh.WIDTH; child++) {
            int at = node * Bvh.NODE_STRIDE + child;
            if (bvh.nodes()[at + Bvh.HALF] >= 0) {
                deepest = Math.max(deepest, depth(bvh, bvh.child(at)));
            }
        }
        return deepest + 1;
    }
}
