package raytracer.tracer;

import java.util.Arrays;

/**
 * All rays of a tile at once: the intervals in which their origins and directions lie. One walk of a {@link Bvh} finds
 * the things that any of them may meet (interval arithmetic as in Boulos, Wald and Shirley, Geometric and Arithmetic
 * Culling Methods for Entire Ray Packets, 2006). Where rays start or aim alike, those are so few that trying each with
 * all rays beats a walk per ray; where they are not, the search is given up soon.
 */
final class Beam {

    /** The most things that are still worth trying with every ray. */
    private static final int MOST = 24;

    /** The most nodes to visit: what a few rays' own walks would. */
    private static final int MOST_NODES = 96;

    /** In tree space: from farther away, the doubles here are not exact enough for the boxes' padding. */
    private static final double FARTHEST = 0x1p20;

    // By axis: the intervals of origins and directions.
    private final double[] leastOrigin = new double[3];
    private final double[] greatestOrigin = new double[3];
    private final double[] leastDirection = new double[3];
    private final double[] greatestDirection = new double[3];
    private double reach;

    private final int[] things = new int[MOST + Bvh.LEAF_SIZE];
    private int count;
    private int[] stack = new int[64];

    /** Takes in rays, the first so many of these arrays, as far as their distances. */
    void span(int rays, double[] ox, double[] oy, double[] oz, double[] dx, double[] dy, double[] dz,
            double[] distance) {
        span(rays, ox, leastOrigin, greatestOrigin, 0);
        span(rays, oy, leastOrigin, greatestOrigin, 1);
        span(rays, oz, leastOrigin, greatestOrigin, 2);
        span(rays, dx, leastDirection, greatestDirection, 0);
        span(rays, dy, leastDirection, greatestDirection, 1);
        span(rays, dz, leastDirection, greatestDirection, 2);
        reach = 0;
        for (int i = 0; i < rays; i++) {
            reach = distance[i] > reach ? distance[i] : reach;
        }
    }

    /** Comparisons, not the library's min and max: a NaN among the values is left out, and its ray meets nothing. */
    private static void span(int count, double[] values, double[] least, double[] greatest, int axis) {
        double low = Double.POSITIVE_INFINITY, high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double v = values[i];
            low = v < low ? v : low;
            high = v > high ? v : high;
        }
        least[axis] = low;
        greatest[axis] = high;
    }

    /** Finds the things in the tree that the rays may meet; false if they are too many, or the rays too unlike. */
    boolean gather(Bvh bvh) {
        count = 0;
        if (bvh.root() == Bvh.EMPTY) {
            return true;
        }
        toTreeSpace(bvh);
        if (!isNarrow()) {
            return false;
        }
        int stacked = 0;
        int visited = 0;
        stack[stacked++] = bvh.root();
        while (stacked > 0) {
            int child = stack[--stacked];
            if (child < 0) {
                for (int k = Bvh.leafFirst(child); k < Bvh.leafEnd(child); k++) {
                    things[count++] = k;
                }
                if (count > MOST) {
                    return false;
                }
            } else {
                if (++visited > MOST_NODES) {
                    return false;
                }
                if (stacked + Bvh.WIDTH > stack.length) {
                    stack = Arrays.copyOf(stack, 2 * stack.length);
                }
                stacked = push(bvh, child, stacked);
            }
        }
        return true;
    }

    int count() {
        return count;
    }

    /** Thing number i of those found: its place in the tree's order. */
    int thing(int i) {
        return things[i];
    }

    private void toTreeSpace(Bvh bvh) {
        double[] centre = {bvh.centreX(), bvh.centreY(), bvh.centreZ()};
        for (int axis = 0; axis < 3; axis++) {
            leastOrigin[axis] = (leastOrigin[axis] - centre[axis]) * bvh.scale();
            greatestOrigin[axis] = (greatestOrigin[axis] - centre[axis]) * bvh.scale();
        }
        // Rounded up by more than hits are compared by; the padding has room for it.
        reach *= bvh.scale() * (1 + 2 * Rounding.TIE_SIEVE);
    }

    /** Whether the rays go the same way along at least one axis, and start near enough. */
    private boolean isNarrow() {
        boolean narrow = false;
        for (int axis = 0; axis < 3; axis++) {
            if (!(Math.abs(leastOrigin[axis]) < FARTHEST && Math.abs(greatestOrigin[axis]) < FARTHEST)) {
                return false;
            }
            narrow |= leastDirection[axis] > 0 || greatestDirection[axis] < 0;
        }
        return narrow;
    }

    private int push(Bvh bvh, int node, int stacked) {
        int top = stacked;
        for (int child = 0; child < Bvh.WIDTH; child++) {
            if (mayMeet(bvh.boxes(), node * Bvh.BOX_STRIDE + child)) {
                stack[top++] = bvh.children()[node * Bvh.WIDTH + child];
            }
        }
        return top;
    }

    /** Whether the intervals of distances at which the rays are between a box's sides have anything in common. */
    private boolean mayMeet(float[] boxes, int box) {
        double near = 0;
        double far = reach;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[box + 2 * axis * Bvh.WIDTH], high = boxes[box + (2 * axis + 1) * Bvh.WIDTH];
            if (low > high) {
                return false;
            }
            double slow = leastDirection[axis], fast = greatestDirection[axis];
            double toLow = low - greatestOrigin[axis], toHigh = high - leastOrigin[axis];
            if (fast < 0) {
                // The mirror image of what follows.
                slow = -greatestDirection[axis];
                fast = -leastDirection[axis];
                toLow = leastOrigin[axis] - high;
                toHigh = greatestOrigin[axis] - low;
            }
            if (slow > 0) {
                near = Math.max(near, toLow / (toLow >= 0 ? fast : slow));
                far = Math.min(far, toHigh / (toHigh >= 0 ? slow : fast));
            }
        }
        return near <= far;
    }
}
