package raytracer.tracer.search;

import java.util.Arrays;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.rays.Rays;

/**
 * All rays of a tile at once: the intervals in which their origins and directions lie. One walk of a {@link Bvh} finds
 * the primitives that any of them may hit (interval arithmetic as in Boulos, Wald and Shirley, Geometric and Arithmetic
 * Culling Methods for Entire Ray Packets, 2006). Where rays start or aim alike, those are so few that trying each with
 * all rays beats a walk per ray; where they are not, the search is given up soon.
 */
public final class Beam {

    /** The most primitives that are still worth trying with every ray. */
    private static final int MAX = 24;

    /** The most nodes to visit: what a few rays' own walks would. */
    private static final int MAX_NODES = 96;

    // By axis: the intervals of origins and directions, which may be longer than 1.
    private final double[] minOrigin = new double[3];
    private final double[] maxOrigin = new double[3];
    private final double[] minDirection = new double[3];
    private final double[] maxDirection = new double[3];
    private double maxDistance;

    // By axis along which all rays go the same way, in tree space, mirrored (side is -1) where that is down: where the
    // first and the last of them starts, and how far the slowest and the fastest go for each unit along the axis.
    // Where they go both ways perMin is 0: such an axis tells nothing.
    private final double[] side = new double[3];
    private final double[] first = new double[3];
    private final double[] last = new double[3];
    private final double[] perMin = new double[3];
    private final double[] perMax = new double[3];

    private final int[] primitives = new int[MAX + Bvh.LEAF_SIZE];
    private int count;
    private int entry;
    private int[] stack = new int[64];

    /** Takes in a tile's rays, from one index to another, as far as their distances. */
    void enclose(Rays rays, int from, int to) {
        if (rays.leaveEye) {
            point(rays.ox[from], rays.oy[from], rays.oz[from], minOrigin, maxOrigin);
        } else {
            span(rays.ox, rays.oy, rays.oz, from, to, minOrigin, maxOrigin);
        }
        span(rays.dx, rays.dy, rays.dz, from, to, minDirection, maxDirection);
        maxDistance = 0;
        for (int i = from; i < to; i++) {
            maxDistance = rays.distance[i] > maxDistance ? rays.distance[i] : maxDistance;
        }
    }

    /** Takes in a bundle's rays. */
    void enclose(RayBundle bundle) {
        System.arraycopy(bundle.minOrigin, 0, minOrigin, 0, minOrigin.length);
        System.arraycopy(bundle.maxOrigin, 0, maxOrigin, 0, maxOrigin.length);
        System.arraycopy(bundle.minDirection, 0, minDirection, 0, minDirection.length);
        System.arraycopy(bundle.maxDirection, 0, maxDirection, 0, maxDirection.length);
        maxDistance = bundle.maxDistance;
    }

    /**
     * Takes in the ways from where rays have arrived to a light. From a light at a point they are taken backwards, as
     * the beam that starts as a point is narrower; distances are then in parts of the way.
     */
    void enclose(Rays rays, LightSource light, int from, int to) {
        span(rays.ox, rays.oy, rays.oz, from, to, minOrigin, maxOrigin);
        if (light.directional()) {
            point(light.x(), light.y(), light.z(), minDirection, maxDirection);
            maxDistance = Double.POSITIVE_INFINITY;
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            double position = axis == 0 ? light.x() : axis == 1 ? light.y() : light.z();
            minDirection[axis] = minOrigin[axis] - position;
            maxDirection[axis] = maxOrigin[axis] - position;
            minOrigin[axis] = position;
            maxOrigin[axis] = position;
        }
        maxDistance = 1;
    }

    private static void point(double x, double y, double z, double[] min, double[] max) {
        min[0] = max[0] = x;
        min[1] = max[1] = y;
        min[2] = max[2] = z;
    }

    private static void span(double[] x, double[] y, double[] z, int from, int to, double[] min, double[] max) {
        span(x, from, to, min, max, 0);
        span(y, from, to, min, max, 1);
        span(z, from, to, min, max, 2);
    }

    /** Comparisons, not the library's min and max: a NaN among the values is left out, and its ray hits nothing. */
    private static void span(double[] values, int from, int to, double[] min, double[] max, int axis) {
        double low = Double.POSITIVE_INFINITY, high = Double.NEGATIVE_INFINITY;
        for (int i = from; i < to; i++) {
            double v = values[i];
            low = v < low ? v : low;
            high = v > high ? v : high;
        }
        min[axis] = low;
        max[axis] = high;
    }

    /**
     * Finds the primitives in the tree that the rays may hit, and where walks may begin; false if they are too many, or the
     * rays too unlike.
     */
    boolean gather(Bvh bvh) {
        count = 0;
        entry = bvh.root();
        if (bvh.root() == Bvh.EMPTY) {
            return true;
        }
        toTreeSpace(bvh);
        if (!isNarrow()) {
            return false;
        }
        prepare();
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
                    primitives[count++] = k;
                }
                if (count > MAX) {
                    return false;
                }
            } else {
                if (++visited > MAX_NODES) {
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

    /** The deepest node or leaf that holds all that the rays may hit: where their own walks may begin. */
    int entry() {
        return entry;
    }

    /** Primitive number i of those found: its place in the tree's order. */
    int primitive(int i) {
        return primitives[i];
    }

    private void toTreeSpace(Bvh bvh) {
        for (int axis = 0; axis < 3; axis++) {
            minOrigin[axis] = bvh.space().coordinate(axis, minOrigin[axis]);
            maxOrigin[axis] = bvh.space().coordinate(axis, maxOrigin[axis]);
        }
        // Rounded up by more than hits are compared by; the padding has room for it.
        maxDistance *= bvh.space().scale() * (1 + 2 * Rounding.TIE_SIEVE);
    }

    /** Whether the rays go the same way along at least one axis, and start near enough. */
    private boolean isNarrow() {
        boolean narrow = false;
        for (int axis = 0; axis < 3; axis++) {
            if (!(Math.abs(minOrigin[axis]) < Bvh.FARTHEST && Math.abs(maxOrigin[axis]) < Bvh.FARTHEST)) {
                return false;
            }
            narrow |= isOneWay(axis);
        }
        return narrow;
    }

    /** Whether all rays go up along an axis, or all down; not so slowly that a reciprocal would overflow. */
    private boolean isOneWay(int axis) {
        return minDirection[axis] >= Double.MIN_NORMAL || maxDirection[axis] <= -Double.MIN_NORMAL;
    }

    private void prepare() {
        for (int axis = 0; axis < 3; axis++) {
            boolean up = minDirection[axis] > 0;
            side[axis] = up ? 1 : -1;
            first[axis] = up ? minOrigin[axis] : -maxOrigin[axis];
            last[axis] = up ? maxOrigin[axis] : -minOrigin[axis];
            perMin[axis] = isOneWay(axis) ? 1 / (up ? minDirection[axis] : -maxDirection[axis]) : 0;
            perMax[axis] = 1 / (up ? maxDirection[axis] : -minDirection[axis]);
        }
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
