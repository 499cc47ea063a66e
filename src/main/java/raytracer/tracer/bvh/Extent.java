package raytracer.tracer.bvh;

/**
 * The box around numbered primitives.
 *
 * @param box least x, y, z, then greatest x, y, z; with no primitives, from infinity to negative infinity
 */
record Extent(double[] box) {

    /** Of the primitives from one place in an order on. */
    static Extent of(int[] order, int from, Bounds bounds) {
        double inf = Double.POSITIVE_INFINITY;
        double[] all = {inf, inf, inf, -inf, -inf, -inf};
        double[] box = new double[6];
        for (int i = from; i < order.length; i++) {
            bounds.of(order[i], box);
            for (int axis = 0; axis < 3; axis++) {
                all[axis] = Math.min(all[axis], box[axis]);
                all[axis + 3] = Math.max(all[axis + 3], box[axis + 3]);
            }
        }
        return new Extent(all);
    }

    /** The greatest of a box's three lengths. */
    static double width(double[] box) {
        return Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
    }

    /** The space in which the box is in the middle and from a half to less than 1 wide on either side. */
    TreeSpace space() {
        double width = width(box);
        return new TreeSpace(middle(0), middle(1), middle(2),
                width > 0 ? Math.scalb(1.0, -Math.getExponent(width)) : 1);
    }

    private double middle(int axis) {
        return box[axis] / 2 + box[axis + 3] / 2;
    }
}
