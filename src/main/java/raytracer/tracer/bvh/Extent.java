package raytracer.tracer.bvh;

import java.util.concurrent.ForkJoinPool;

/** The box around numbered primitives, and how wide the widest of them is. */
public final class Extent {

    private final double[] box = new double[6];
    private double widest;

    private Extent() {
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = Double.POSITIVE_INFINITY;
            box[axis + 3] = Double.NEGATIVE_INFINITY;
        }
    }

    /** Of the primitives from one place in an order on. */
    static Extent of(int[] order, int from, Bounds bounds, ForkJoinPool pool) {
        Extent all = new Extent();
        ParallelRange.run(pool, from, order.length, new Inclusion(order, bounds, all));
        return all;
    }

    private record Inclusion(int[] order, Bounds bounds, Extent all) implements ParallelRange.Work {
        @Override
        public void over(int from, int to) {
            Extent part = new Extent();
            double[] primitive = new double[6];
            for (int k = from; k < to; k++) {
                bounds.of(order[k], primitive);
                part.include(primitive, width(primitive));
            }
            all.merge(part);
        }
    }

    /** The same comes out in whatever order threads do this. */
    private synchronized void merge(Extent part) {
        include(part.box, part.widest);
    }

    private void include(double[] other, double otherWidest) {
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = Math.min(box[axis], other[axis]);
            box[axis + 3] = Math.max(box[axis + 3], other[axis + 3]);
        }
        widest = Math.max(widest, otherWidest);
    }

    /** The greatest of a box's three lengths. */
    static double width(double[] box) {
        return Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
    }

    /** Negative infinity if there are no primitives. */
    double width() {
        return width(box);
    }

    /** The greatest of any primitive's lengths. */
    double widest() {
        return widest;
    }

    /** Of the box, along one axis; not a number if there are no primitives. */
    double middle(int axis) {
        return box[axis] / 2 + box[axis + 3] / 2;
    }
}
