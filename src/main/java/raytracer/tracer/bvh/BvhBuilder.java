package raytracer.tracer.bvh;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveTask;

/**
 * Builds a {@link Bvh} from the top by the surface area heuristic, tried at 16 places along the axis on which the
 * boxes' centres spread most ({@link SahSplitter}). Large parts are built in parallel; the tree does not depend on
 * the number of threads.
 */
public final class BvhBuilder {

    /** Fewer primitives than this are not worth another task. */
    private static final int PARALLEL_SIZE = 4096;

    /** A primitive is oversized if its box is more than this part as wide as all boxes together. */
    private static final double TOO_WIDE = 0.5;

    /** The most that are: each costs every ray a test. */
    private static final int MAX_OVERSIZED = 8;

    /** A leaf of so many primitives is not split, even where there is room for another. */
    private static final int SMALL_LEAF = 2;

    private final int[] primitives;
    private final float[] boxes;
    private final Bounds bounds;
    private final int leafSize;

    private BvhBuilder(int[] primitives, float[] boxes, Bounds bounds, int leafSize) {
        this.primitives = primitives;
        this.boxes = boxes;
        this.bounds = bounds;
        this.leafSize = leafSize;
    }

    /** @param leafSize the most primitives in a leaf, at most {@link Bvh#LEAF_SIZE} */
    public static Bvh build(int count, Bounds bounds, int leafSize, ForkJoinPool pool) {
        int[] order = Bvh.numbers(count);
        Extent extent = Extent.of(order, 0, bounds, pool);
        int oversized = 0;
        // Without the widest the others may have a much smaller box, in which some are the widest again.
        for (int found; (found = setAside(order, oversized, bounds, extent)) != oversized; ) {
            oversized = found;
            extent = Extent.of(order, oversized, bounds, pool);
        }
        if (oversized == count) {
            return Bvh.withoutTree(count);
        }
        TreeSpace space = new TreeSpace(extent.middle(0), extent.middle(1), extent.middle(2), scale(extent.width()));
        float[] boxes = new float[6 * (count - oversized)];
        ParallelRange.run(pool, oversized, count, new TreeBoxes(boxes, oversized, order, bounds, space));
        Nodes nodes = new Nodes();
        int root = Bvh.leaf(oversized, count - oversized);
        if (count - oversized > leafSize) {
            Range whole = new Range(oversized, count, 0, null);
            Subtree subtree = new BvhBuilder(order, boxes, bounds, leafSize).new Subtree(whole, oversized);
            nodes = whole.size() < PARALLEL_SIZE ? subtree.compute() : pool.invoke(subtree);
            root = 0;
        }
        return new Bvh(order, oversized, nodes.numbers(), root, space);
    }

    /** Brings the primitives that are too wide to the front; all or, if there are too many of them, none. */
    private static int setAside(int[] order, int from, Bounds bounds, Extent extent) {
        double tooWide = TOO_WIDE * extent.width();
        if (extent.widest() <= tooWide) {
            return from;
        }
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

    /** The power of two that brings half of a width to 1/2 or more, and below 1. */
    private static double scale(double width) {
        return width > 0 ? Math.scalb(1.0, -Math.getExponent(width)) : 1;
    }

    /** Brings the boxes of primitives, from the first in the tree on, to tree space. */
    private record TreeBoxes(float[] boxes, int first, int[] order, Bounds bounds, TreeSpace space)
            implements ParallelRange.Work {
        @Override
        public void over(int from, int to) {
            double[] box = new double[6];
            for (int i = from; i < to; i++) {
                bounds.of(order[i], box);
                for (int side = 0; side < 6; side++) {
                    boxes[6 * (i - first) + side] = (float) space.coordinate(side % 3, box[side]);
                }
            }
        }
    }

    /** Primitives {@code from} to {@code to - 1}, the box around them and half of its surface. */
    private record Range(int from, int to, float area, float[] box) {

        int size() {
            return to - from;
        }
    }

    /** A range that is to become a child, here or, if it is large, as a subtree of its own. */
    private record Part(int node, int child, Range range, Subtree subtree) { }

    /** Builds the nodes below and including that of one range; its own node comes first. */
    private final class Subtree extends RecursiveTask<Nodes> {

        private static final long serialVersionUID = 1;

        private final transient Range range;
        private final int offset;
        private final transient SahSplitter split;

        /** @param offset where the first box's primitive is in the order */
        Subtree(Range range, int offset) {
            this.range = range;
            this.offset = offset;
            split = new SahSplitter(primitives, boxes, offset);
        }

        /** With a stack of its own: C2 would inline a recursion into itself, for a quarter second. */
        @Override
        protected Nodes compute() {
            Nodes nodes = new Nodes();
            Deque<Part> parts = new ArrayDeque<>();
            grow(nodes, range, parts);
            while (!parts.isEmpty()) {
                Part part = parts.pop();
                if (part.subtree != null) {
                    nodes.graft(part.node, part.child, part.subtree.join());
                } else {
                    nodes.setChild(part.node, part.child, grow(nodes, part.range, parts));
                }
            }
            return nodes;
        }

        /** Adds a node, and stacks what is to become its children; returns its number. */
        private int grow(Nodes nodes, Range parent, Deque<Part> parts) {
            int node = nodes.add();
            Range[] ranges = new Range[Bvh.WIDTH];
            for (int k = split(parent, ranges) - 1; k >= 0; k--) {
                Range child = ranges[k];
                nodes.setBox(node, k, child.box);
                if (child.size() <= leafSize) {
                    nodes.setChild(node, k, Bvh.leaf(child.from, child.size()));
                } else if (child.size() > Bvh.LEAF_SIZE && areAllSame(child)) {
                    nodes.setChild(node, k, Bvh.leaf(child.from, 1));
                } else {
                    parts.push(new Part(node, k, child, child.size() < PARALLEL_SIZE ? null : fork(child)));
                }
            }
            return node;
        }

        /** If so, the first declared comes to the front: it wins every tie, so of many a leaf of that one is enough. */
        private boolean areAllSame(Range range) {
            int least = range.from;
            for (int i = range.from + 1; i < range.to; i++) {
                if (!bounds.areSame(primitives[range.from], primitives[i])) {
                    return false;
                }
                least = primitives[i] < primitives[least] ? i : least;
            }
            int first = primitives[least];
            primitives[least] = primitives[range.from];
            primitives[range.from] = first;
            return true;
        }

        private Subtree fork(Range large) {
            Subtree subtree = new Subtree(large, offset);
            subtree.fork();
            return subtree;
        }

        /**
         * Splits a range, then the larger-surfaced of its parts, until there are as many as a node has children. If
         * there is room left, parts are split that could be leaves: smaller ones cost a visitor of the node nothing.
         */
        private int split(Range parent, Range[] parts) {
            parts[0] = parent;
            int count = 1;
            while (count < Bvh.WIDTH) {
                int widest = widest(parts, count, leafSize);
                if (widest < 0) {
                    widest = widest(parts, count, SMALL_LEAF);
                }
                if (widest < 0) {
                    break;
                }
                Range whole = parts[widest];
                int middle = split.at(whole.from, whole.to);
                parts[widest] = new Range(whole.from, middle, split.leftArea(), split.leftBox());
                parts[count++] = new Range(middle, whole.to, split.rightArea(), split.rightBox());
            }
            return count;
        }

        /** The part with the largest surface of those of more primitives than so many; negative if there is none. */
        private static int widest(Range[] parts, int count, int primitives) {
            int widest = -1;
            for (int k = 0; k < count; k++) {
                if (parts[k].size() > primitives && (widest < 0 || parts[k].area > parts[widest].area)) {
                    widest = k;
                }
            }
            return widest;
        }
    }
}
