package raytracer.tracer;

import java.util.Arrays;

/** Nodes of a {@link Bvh} in the making: a growing list, into which a finished subtree's can be copied. */
final class Nodes {

    private float[] numbers;
    private int count;

    /** @param expected how many nodes there will be, about */
    Nodes(int expected) {
        numbers = new float[Math.multiplyExact(expected, Bvh.NODE_STRIDE)];
    }

    /** Adds a node without children; returns its number. */
    int add() {
        reserve(1);
        int at = count * Bvh.NODE_STRIDE;
        for (int axis = 0; axis < 3; axis++) {
            // A box that no ray meets is as wide as less than nothing.
            int half = at + axis * Bvh.AXIS_STRIDE + Bvh.HALF;
            Arrays.fill(numbers, half, half + Bvh.WIDTH, Float.NEGATIVE_INFINITY);
        }
        return count++;
    }

    /** @param box least x, y, z, then greatest x, y, z; padding is added here */
    void setBox(int node, int child, float[] box) {
        for (int axis = 0; axis < 3; axis++) {
            int at = node * Bvh.NODE_STRIDE + axis * Bvh.AXIS_STRIDE + child;
            float least = box[axis] - Bvh.PADDING, greatest = box[axis + 3] + Bvh.PADDING;
            float middle = (least + greatest) / 2;
            numbers[at] = middle;
            // The differences may have been rounded down.
            numbers[at + Bvh.HALF] = Math.nextUp(Math.max(middle - least, greatest - middle));
        }
    }

    void setChild(int node, int child, int value) {
        numbers[node * Bvh.NODE_STRIDE + Bvh.CHILD + child] = Float.intBitsToFloat(value);
    }

    /** Copies all nodes of another list behind these; returns the new number of its first. */
    int append(Nodes other) {
        reserve(other.count);
        int first = count;
        System.arraycopy(other.numbers, 0, numbers, first * Bvh.NODE_STRIDE, other.count * Bvh.NODE_STRIDE);
        count += other.count;
        for (int node = first; node < count; node++) {
            for (int child = 0; child < Bvh.WIDTH; child++) {
                int old = Float.floatToRawIntBits(numbers[node * Bvh.NODE_STRIDE + Bvh.CHILD + child]);
                setChild(node, child, old < 0 ? old : old + first);
            }
        }
        return first;
    }

    private void reserve(int more) {
        int needed = count + more;
        if (Math.multiplyExact(needed, Bvh.NODE_STRIDE) > numbers.length) {
            numbers = Arrays.copyOf(numbers, Math.multiplyExact(needed + needed / 2, Bvh.NODE_STRIDE));
        }
    }

    /** {@link Bvh#NODE_STRIDE} a node, and none for nodes to come. */
    float[] numbers() {
        return Arrays.copyOf(numbers, count * Bvh.NODE_STRIDE);
    }
}
