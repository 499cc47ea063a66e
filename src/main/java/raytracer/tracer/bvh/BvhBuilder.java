package raytracer.tracer.bvh;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.stream.IntStream;
import raytracer.tracer.bvh.SahSplitter.Range;

/**
 * Builds a {@link Bvh} from the top by the surface area heuristic, tried at 16 places along the axis on which the
 * boxes' centres spread most ({@link SahSplitter}).
 */
public final class BvhBuilder {

    /** A primitive is oversized if its box is more than this part as wide as all boxes together. */
    private static final double TOO_WIDE = 0.5;

    /** The most that are: each costs every ray a test. */
    private static final int MAX_OVERSIZED = 8;

    /** A leaf of so many primitives is not split, even where there is room for another. */
    private static final int SMALL_LEAF = 2;

    private final int[] primitives;
    private final Bounds bounds;
    private final int leafSize;
    private final SahSplitter splitter;
    private final Nodes nodes = new Nodes();

    /** What is to become children. */
    private final Deque<Part> parts = new ArrayDeque<>();

    private BvhBuilder(int[] primitives, float[] boxes, Bounds bounds, int leafSize) {
        this.primitives = primitives;
        this.bounds = bounds;
        this.leafSize = leafSize;
        splitter = new SahSplitter(primitives, boxes);
    }

    /** @param leafSize the most primitives in a leaf, at most {@link Bvh#LEAF_SIZE} */
    public static Bvh build(int count, Bounds bounds, int leafSize) {
        int[] order = IntStream.range(0, count).toArray();
        Extent extent = Extent.of(order, 0, bounds);
        int oversized = 0;
        // Without the widest the others may have a much smaller box, in which some are the widest again.
        for (int found; (found = setAside(order, oversized, bounds, extent)) != oversized; ) {
            oversized = found;
            extent = Extent.of(order, oversized, bounds);
        }
        if (oversized == count) {
            return Bvh.withoutTree(count);
        }
        TreeSpace space = extent.space();
        BvhBuilder builder = new BvhBuilder(order, treeBoxes(order, bounds, space), bounds, leafSize);
        int root = builder.build(builder.splitter.range(oversized, count));
        return new Bvh(order, oversized, builder.nodes.numbers(), root, space);
    }

    /** Brings the primitives that are too wide to the front; all or, if there are too many of them, none. */
    private static int setAside(int[] order, int from, Bounds bounds, Extent extent) {
        double tooWide = TOO_WIDE * Extent.width(extent.box());
        double[] box = new double[6];
        int wide = from;
        for (int i = from; i < order.length; i++) {
            bounds.of(order[i], box);
            if (Extent.width(box) > tooWide) {
                if (wide == MAX_OVERSIZED) {
                    return from;
                }
                int primitive = order[i];
                order[i] = order[wide];
                order[wide++] = primitive;
            }
        }
        return wide;
    }

    /** The boxes of primitives in tree space, in some order. */
    private static float[] treeBoxes(int[] order, Bounds bounds, TreeSpace space) {
        float[] boxes = new float[Math.multiplyExact(6, order.length)];
        double[] box = new double[6];
        for (int i = 0; i < order.length; i++) {
            bounds.of(order[i], box);
            for (int side = 0; side < 6; side++) {
                boxes[6 * i + side] = (float) space.coordinate(side % 3, box[side]);
            }
        }
        return boxes;
    }

    /** A range that is to become a child of a node. */
    private record Part(int node, int child, Range range) { }

    /** Returns the root. With a stack of its own: C2 would inline a recursion into itself, for a quarter second. */
    private int build(Range whole) {
        if (whole.size() <= leafSize) {
            return Bvh.leaf(whole.from(), whole.size());
        }
        int root = grow(whole);
        while (!parts.isEmpty()) {
            Part part = parts.pop();
            nodes.setChild(part.node, part.child, grow(part.range));
        }
        return root;
    }

    /** Adds a node, and stacks what is to become its children; returns its number. */
    private int grow(Range parent) {
        int node = nodes.add();
        Range[] ranges = new Range[Bvh.WIDTH];
        for (int k = split(parent, ranges) - 1; k >= 0; k--) {
            Range child = ranges[k];
            nodes.setBox(node, k, child.box());
            if (child.size() <= leafSize) {
                nodes.setChild(node, k, Bvh.leaf(child.from(), child.size()));
            } else if (child.size() > Bvh.LEAF_SIZE && areAllSame(child)) {
                nodes.setChild(node, k, Bvh.leaf(child.from(), 1));
            } else {
                parts.push(new Part(node, k, child));
            }
        }
        return node;
    }

    /** If so, the first declared comes to the front: it wins every tie, so of many a leaf of that one is enough. */
    private boolean areAllSame(Range range) {
        int from = range.from(), least = from;
        for (int i = from + 1; i < range.to(); i++) {
            if (!bounds.areSame(primitives[from], primitives[i])) {
                return false;
            }
            least = primitives[i] < primitives[least] ? i : least;
        }
        int first = primitives[least];
        primitives[least] = primitives[from];
        primitives[from] = first;
        return true;
    }

    /**
     * Splits a range, then the larger-surfaced of its parts, until there are as many as a node has children. If there is
     * room left, parts are split that could be leaves: smaller ones cost a visitor of the node nothing.
     */
    private int split(Range parent, Range[] ranges) {
        ranges[0] = parent;
        int count = 1;
        while (count < Bvh.WIDTH) {
            int widest = widest(ranges, count, leafSize);
            if (widest < 0) {
                widest = widest(ranges, count, SMALL_LEAF);
            }
            if (widest < 0) {
                break;
            }
            Range whole = ranges[widest];
            int middle = splitter.split(whole);
            ranges[widest] = splitter.range(whole.from(), middle);
            ranges[count++] = splitter.range(middle, whole.to());
        }
        return count;
    }

    /** The range with the largest surface of those of more primitives than so many; negative if there is none. */
    private static int widest(Range[] ranges, int count, int primitives) {
        int widest = -1;
        for (int k = 0; k < count; k++) {
            if (ranges[k].size() > primitives && (widest < 0 || ranges[k].area() > ranges[widest].area())) {
                widest = k;
            }
        }
        return widest;
    }
}
