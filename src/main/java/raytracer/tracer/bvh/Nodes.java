package raytracer.tracer.bvh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Nodes of a {@link Bvh} in the making: a growing list, to which subtrees are grafted that were made elsewhere. All are
 * copied to one place once, at the end: each large array on the way would have the garbage collector look at the heap.
 */
public final class Nodes {

    /** In nodes; a list grows by half of itself. */
    private static final int FIRST_CAPACITY = 64;

    private float[] numbers = new float[FIRST_CAPACITY * Bvh.NODE_STRIDE];
    private int count;
    private final List<Graft> grafts = new ArrayList<>();

    /** A child that is the first node of another list. */
    private record Graft(int node, int child, Nodes nodes) { }

    /** Adds a node without children; returns its number. */
    int add() {
        if (Math.multiplyExact(count + 1, Bvh.NODE_STRIDE) > numbers.length) {
            numbers = Arrays.copyOf(numbers, Math.multiplyExact(count + count / 2, Bvh.NODE_STRIDE));
        }
        int at = count * Bvh.NODE_STRIDE;
        for (int axis = 0; axis < 3; axis++) {
            // A box that no ray hits is as wide as less than nothing.
            int half = at + axis * Bvh.AXIS_STRIDE + Bvh.HALF;
            Arrays.fill(numbers, half, half + Bvh.WIDTH, Float.NEGATIVE_INFINITY);
        }
        return count++;
    }

    /** @param box least x, y, z, then greatest x, y, z; padding is added here */
    void setBox(int node, int child, float[] box) {
        for (int axis = 0; axis < 3; axis++) {
            int at = node * Bvh.NODE_STRIDE + axis * Bvh.AXIS_STRIDE + child;
            float min = box[axis] - Bvh.PADDING, max = box[axis + 3] + Bvh.PADDING;
            float middle = (min + max) / 2;
            numbers[at] = middle;
            // The differences may have been rounded down.
            numbers[at + Bvh.HALF] = Math.nextUp(Math.max(middle - min, max - middle));
        }
    }

    void setChild(int node, int child, int value) {
        numbers[node * Bvh.NODE_STRIDE + Bvh.CHILD + child] = Float.intBitsToFloat(value);
    }

    /** Makes the first of other nodes a child; they must be complete. */
    void graft(int node, int child, Nodes other) {
        grafts.add(new Graft(node, child, other));
    }

    /** {@link Bvh#NODE_STRIDE} a node: these, then those of each graft. */
    float[] numbers() {
        float[] all = new float[Math.multiplyExact(size(), Bvh.NODE_STRIDE)];
        copy(all, 0);
        return all;
    }

    private int size() {
        int size = count;
        for (Graft graft : grafts) {
            size += graft.nodes.size();
        }
        return size;
    }

    /** Copies all to another place, where the first becomes this number; returns the number behind the last. */
    private int copy(float[] all, int first) {
        System.arraycopy(numbers, 0, all, first * Bvh.NODE_STRIDE, count * Bvh.NODE_STRIDE);
        for (int node = first; node < first + count; node++) {
            for (int child = 0; child < Bvh.WIDTH; child++) {
                int at = node * Bvh.NODE_STRIDE + Bvh.CHILD + child;
                int old = Float.floatToRawIntBits(all[at]);
                all[at] = Float.intBitsToFloat(old < 0 ? old : old + first);
            }
        }
        int end = first + count;
        for (Graft graft : grafts) {
            all[(first + graft.node) * Bvh.NODE_STRIDE + Bvh.CHILD + graft.child] = Float.intBitsToFloat(end);
            end = graft.nodes.copy(all, end);
        }
        return end;
    }
}
