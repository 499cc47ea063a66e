package raytracer.exact;

import java.util.Arrays;
import java.util.Comparator;
import java.util.function.IntConsumer;
import raytracer.scene.Vector;

/**
 * Finds the few boxes that a line may pass, of many: a binary tree, in doubles. Boxes are enlarged by far more than
 * doubles round, so that none is missed; what is found is then tried exactly.
 */
final class BoxTree {

    /** Of a box's coordinates, and of the line's origin. */
    private static final double MARGIN = 1e-9;

    private static final int LEAF = 2;

    /** By item: least x, y, z, greatest x, y, z. */
    private final double[][] boxes;
    private final Node root;

    /** @param items in a leaf; null in a node with children */
    private record Node(double[] box, int[] items, Node left, Node right) { }

    /** @param boxes of items that are numbered from 0; null for an item without end, which is always found */
    BoxTree(double[][] boxes) {
        this.boxes = boxes;
        root = build(boxedItems());
    }

    private Integer[] boxedItems() {
        Integer[] all = new Integer[boxes.length];
        Arrays.setAll(all, i -> i);
        return Arrays.stream(all).filter(i -> boxes[i] != null).toArray(Integer[]::new);
    }

    private Node build(Integer[] items) {
        double[] box = {1e300, 1e300, 1e300, -1e300, -1e300, -1e300};
        for (int i : items) {
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], boxes[i][axis]);
                box[axis + 3] = Math.max(box[axis + 3], boxes[i][axis + 3]);
            }
        }
        if (items.length <= LEAF) {
            return new Node(box, Arrays.stream(items).mapToInt(i -> i).toArray(), null, null);
        }
        int widest = 0;
        for (int axis = 1; axis < 3; axis++) {
            widest = box[axis + 3] - box[axis] > box[widest + 3] - box[widest] ? axis : widest;
        }
        int axis = widest;
        Arrays.sort(items, Comparator.comparingDouble(i -> boxes[i][axis] + boxes[i][axis + 3]));
        int middle = items.length / 2;
        return new Node(box, null, build(Arrays.copyOf(items, middle)),
                build(Arrays.copyOfRange(items, middle, items.length)));
    }

    /** Names every item whose box the half-line may pass, and every item without a box; in any order. */
    void find(Vector origin, Vector direction, IntConsumer found) {
        for (int i = 0; i < boxes.length; i++) {
            if (boxes[i] == null) {
                found.accept(i);
            }
        }
        find(root, new double[] {origin.x(), origin.y(), origin.z()},
                new double[] {direction.x(), direction.y(), direction.z()}, found);
    }

    private void find(Node node, double[] o, double[] d, IntConsumer found) {
        if (node.items != null) {
            for (int i : node.items) {
                if (mayPass(boxes[i], o, d)) {
                    found.accept(i);
                }
            }
        } else if (mayPass(node.box, o, d)) {
            find(node.left, o, d, found);
            find(node.right, o, d, found);
        }
    }

    private static boolean mayPass(double[] box, double[] o, double[] d) {
        double size = 0;
        for (int axis = 0; axis < 3; axis++) {
            size = Math.max(size, Math.abs(o[axis]) + Math.abs(box[axis]) + Math.abs(box[axis + 3]));
        }
        double margin = MARGIN * size, near = 0, far = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double low = box[axis] - margin - o[axis], high = box[axis + 3] + margin - o[axis];
            if (Math.abs(d[axis]) < MARGIN * MARGIN) {
                if (low > 0 || high < 0) {
                    return false;
                }
            } else {
                near = Math.max(near, Math.min(low / d[axis], high / d[axis]));
                far = Math.min(far, Math.max(low / d[axis], high / d[axis]));
            }
        }
        return near <= far;
    }
}
