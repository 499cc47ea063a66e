package raytracer.tracer;

import java.util.Arrays;

/** Nodes of a {@link Bvh} in the making: a growing list, into which a finished subtree's can be copied. */
final class Nodes {

    private float[] boxes;
    private int[] children;
    private int count;

    /** @param expected how many nodes there will be, about */
    Nodes(int expected) {
        boxes = new float[Math.multiplyExact(expected, Bvh.BOX_STRIDE)];
        children = new int[expected * Bvh.WIDTH];
    }

    /** Adds a node without children; returns its number. */
    int add() {
        reserve(1);
        int box = count * Bvh.BOX_STRIDE;
        for (int side = 0; side < 6; side++) {
            // An empty box is inside out on every axis.
            float nowhere = side % 2 == 0 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
            Arrays.fill(boxes, box + side * Bvh.WIDTH, box + (side + 1) * Bvh.WIDTH, nowhere);
        }
        return count++;
    }

    /** @param box least x, y, z, then greatest x, y, z; padding is added here */
    void setBox(int node, int child, float[] box) {
        int at = node * Bvh.BOX_STRIDE + child;
        for (int axis = 0; axis < 3; axis++) {
            boxes[at + 2 * axis * Bvh.WIDTH] = box[axis] - Bvh.PADDING;
            boxes[at + (2 * axis + 1) * Bvh.WIDTH] = box[axis + 3] + Bvh.PADDING;
        }
    }

    void setChild(int node, int child, int value) {
        children[node * Bvh.WIDTH + child] = value;
    }

    /** Copies all nodes of another list behind these; returns the new number of its first. */
    int append(Nodes other) {
        reserve(other.count);
        int first = count;
        System.arraycopy(other.boxes, 0, boxes, first * Bvh.BOX_STRIDE, other.count * Bvh.BOX_STRIDE);
        for (int i = 0; i < other.count * Bvh.WIDTH; i++) {
            int child = other.children[i];
            children[first * Bvh.WIDTH + i] = child < 0 ? child : child + first;
        }
        count += other.count;
        return first;
    }

    private void reserve(int more) {
        int needed = count + more;
        if (needed * Bvh.WIDTH > children.length) {
            int nodes = Math.max(needed, needed + needed / 2);
            boxes = Arrays.copyOf(boxes, Math.multiplyExact(nodes, Bvh.BOX_STRIDE));
            children = Arrays.copyOf(children, nodes * Bvh.WIDTH);
        }
    }

    float[] boxes() {
        return boxes;
    }

    int[] children() {
        return children;
    }
}
