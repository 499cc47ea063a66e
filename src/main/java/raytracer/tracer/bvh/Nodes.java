package raytracer.tracer.bvh;

import java.util.Arrays;

/** Nodes of a {@link Bvh} in the making: a growing list. */
final class Nodes {

    /** In nodes; the list grows by half of itself. */
    private static final int FIRST_CAPACITY = 64;

    private float[] numbers = new float[FIRST_CAPACITY * Bvh.NODE_STRIDE];
    private int count;

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

    /** {@link Bvh#NODE_STRIDE} a node. */
    float[] numbers() {
        return Arrays.copyOf(numbers, count * Bvh.NODE_STRIDE);
    }
}
