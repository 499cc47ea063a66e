package raytracer.tracer.search;

import java.util.Arrays;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.TreeSpace;
import raytracer.tracer.rays.RayIntervals;

/**
 * All rays of a tile at once: the intervals in which their origins and directions lie. One walk of a {@link Bvh} finds
 * the primitives that any of them may hit (interval arithmetic as in Boulos, Wald and Shirley, Geometric and Arithmetic
 * Culling Methods for Entire Ray Packets, 2006). Where rays start or aim alike, those are so few that trying each with
 * all rays beats a walk per ray; where they are not, the search is given up soon.
 */
public final class Beam {

    /** The most nodes to visit, if not so many primitives are asked for: what a few rays' own walks would. */
    private static final int MAX_NODES = 96;

    /** How far rays go, in tree space. */
    private double maxDistance;

    // By axis along which all rays go the same way, in tree space, mirrored (side is -1) where that is down: where the
    // first and the last of them starts, and how far the slowest and the fastest go for each unit along the axis.
    // Where they go both ways perMin is 0: such an axis tells nothing.
    private final double[] side = new double[3];
    private final double[] first = new double[3];
    private final double[] last = new double[3];
    private final double[] perMin = new double[3];
    private final double[] perMax = new double[3];

    // What the last search found: so many primitives, by their places in the tree's order; and the deepest node or leaf
    // that holds all that the rays may hit, where their own walks may begin.
    int[] primitives = new int[64];
    int count;
    int entry;

    private int[] stack = new int[64];

    /**
     * Finds the primitives in the tree that the rays may hit, and where walks may begin; false if they are more than so many,
     * or the rays too unlike.
     */
    boolean gather(RayIntervals rays, Bvh bvh, int max) {
        count = 0;
        entry = bvh.root();
        if (bvh.root() == Bvh.EMPTY) {
            return true;
        }
        if (!enclose(rays, bvh.space())) {
            return false;
        }
        int stacked = 0;
        int visited = 0;
        stack[stacked++] = bvh.root();
        while (stacked > 0) {
            int child = stack[--stacked];
            if (stacked == 0 && count == 0) {
                entry = child;
            }
            if (child < 0) {
                for (int k = Bvh.leafFirst(child); k < Bvh.leafEnd(child); k++) {
                    add(k);
                }
                if (count > max) {
                    return false;
                }
            } else {
                if (++visited > Math.max(max, MAX_NODES)) {
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

    private void add(int k) {
        if (count == primitives.length) {
            primitives = Arrays.copyOf(primitives, 2 * count);
        }
        primitives[count++] = k;
    }

    /** Whether the rays start near enough, and go the same way along at least one axis. */
    private boolean enclose(RayIntervals rays, TreeSpace space) {
        // Rounded up by more than hits are compared by; the padding has room for it.
        maxDistance = rays.maxDistance * space.scale() * (1 + 2 * Rounding.TIE_SIEVE);
        boolean isNarrow = false;
        for (int axis = 0; axis < 3; axis++) {
            double low = space.coordinate(axis, rays.minOrigin[axis]), high = space.coordinate(axis, rays.maxOrigin[axis]);
            double min = rays.minDirection[axis], max = rays.maxDirection[axis];
            if (!(Math.abs(low) < Bvh.FARTHEST && Math.abs(high) < Bvh.FARTHEST)) {
                return false;
            }
            boolean up = min > 0;
            // Not so slowly that a reciprocal would overflow.
            boolean isOneWay = min >= Double.MIN_NORMAL || max <= -Double.MIN_NORMAL;
            isNarrow |= isOneWay;
            side[axis] = up ? 1 : -1;
            first[axis] = up ? low : -high;
            last[axis] = up ? high : -low;
            perMin[axis] = isOneWay ? 1 / (up ? min : -max) : 0;
            perMax[axis] = 1 / (up ? max : -min);
        }
        return isNarrow;
    }

    private int push(Bvh bvh, int node, int stacked) {
        int top = stacked;
        for (int child = 0; child < Bvh.WIDTH; child++) {
            int at = node * Bvh.NODE_STRIDE + child;
            if (distance(bvh.nodes(), at) < Double.POSITIVE_INFINITY) {
                stack[top++] = bvh.child(at);
            }
        }
        return top;
    }

    /**
     * How far away, at least, rays may hit a box, in tree space; infinite if none does: if the intervals of distances
     * at which the rays are between the box's sides have nothing in common.
     *
     * @param at the box's place among the nodes' numbers
     */
    double distance(float[] nodes, int at) {
        if (nodes[at + Bvh.HALF] < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double near = 0;
        double far = maxDistance;
        for (int axis = 0; axis < 3; axis++) {
            if (perMin[axis] > 0) {
                double middle = nodes[at + axis * Bvh.AXIS_STRIDE] * side[axis];
                double half = nodes[at + axis * Bvh.AXIS_STRIDE + Bvh.HALF];
                double toLow = middle - half - last[axis], toHigh = middle + half - first[axis];
                double low = toLow * (toLow >= 0 ? perMax[axis] : perMin[axis]);
                double high = toHigh * (toHigh >= 0 ? perMin[axis] : perMax[axis]);
                near = low > near ? low : near;
                far = high < far ? high : far;
            }
        }
        return near <= far ? near : Double.POSITIVE_INFINITY;
    }
}
