package raytracer.tracer.bvh;

import java.util.stream.IntStream;

/**
 * A bounding volume hierarchy with four children a node, and a few oversized primitives, for which a tree is of no
 * use: every ray tries those.
 *
 * <p>Boxes are floats in the tree's own space, in which the primitives fill the cube from -1 to 1. They are
 * conservative: {@link #PADDING} covers every rounding between a primitive and a ray's test of its box.
 *
 * @param order    the primitives: the oversized ones, then those in the order of the leaves
 * @param oversized how many are oversized
 * @param nodes    {@link #NODE_STRIDE} numbers a node
 * @param root     a node's number, a leaf, or {@link #EMPTY}
 */
public record Bvh(int[] order, int oversized, float[] nodes, int root, TreeSpace space) {

    public static final int WIDTH = 4;

    /**
     * Numbers of one node: axis by axis the middles of the four children's boxes, then half of their widths; then, as
     * the bits of floats, the children; then nothing, so that a node takes up two lines of a cache.
     */
    public static final int NODE_STRIDE = 32;

    /** From one axis to the next in a node, and from a box's middle to half of its width. */
    public static final int AXIS_STRIDE = 2 * WIDTH;
    public static final int HALF = WIDTH;

    /** From the middle of a child's box on the first axis to the child. */
    static final int CHILD = 3 * AXIS_STRIDE;

    /** In place of a root. */
    public static final int EMPTY = -1;

    /** In tree space: from farther away, doubles are not exact enough for the boxes' padding. */
    public static final double FARTHEST = 0x1p20;

    /** The most primitives in a leaf. */
    public static final int LEAF_SIZE = 8;

    /**
     * By how much each box is larger than what it holds, on every side, in tree space. With v = 2^-24, floats' unit
     * roundoff, and coordinates up to 1: a corner rounds by v, an origin by v, the origin times the reciprocal of the
     * direction by 2v, the distance to the plane through the box's middle by 2v, and the slab distances, at most
     * 2 sqrt 3, by 2v of themselves: 13v in all. 5v more keep a box in reach whose hit would tie with the nearest (a
     * bound on rounding as in Ize, Robust BVH Ray Traversal, JCGT 2013, in which the padding is at the far distance
     * instead); the rest is {@link #ROOM}.
     */
    public static final float PADDING = 20 * 0x1p-24f;

    /** How far beside its box a primitive may be hit, for rounding, in tree space. */
    private static final double ROOM = 2 * 0x1p-24;

    /** So many primitives that are all oversized. */
    public static Bvh withoutTree(int count) {
        return new Bvh(IntStream.range(0, count).toArray(), count, new float[0], EMPTY, new TreeSpace(0, 0, 0, 1));
    }

    /**
     * So far beside its box a primitive may be hit, and every search finds it: a ray that is off by more is taken as it
     * is. Else it would hit or miss by which rays are searched with it. Without a tree there is no limit.
     */
    public double room() {
        return root == EMPTY ? Double.POSITIVE_INFINITY : ROOM / space.scale();
    }

    /**
     * A leaf of primitives {@code first} to {@code first + count - 1} in {@link #order}; negative. Never the bits of
     * a NaN: a copy of a float may change those.
     */
    static int leaf(int first, int count) {
        return Integer.MIN_VALUE | first * LEAF_SIZE + count - 1;
    }

    public static int leafFirst(int leaf) {
        return (leaf & Integer.MAX_VALUE) / LEAF_SIZE;
    }

    public static int leafEnd(int leaf) {
        return leafFirst(leaf) + (leaf & Integer.MAX_VALUE) % LEAF_SIZE + 1;
    }

    /** A child: a leaf, or a node's number, as is not negative. */
    public int child(int at) {
        return Float.floatToRawIntBits(nodes[at + CHILD]);
    }
}
