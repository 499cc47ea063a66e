package raytracer.tracer.bvh;

import java.util.Arrays;

/**
 * Splits ranges of primitives in two by the surface area heuristic: along the axis on which the boxes' centres spread
 * most, at the best of the limits between {@link #BINS} bins (Wald, On fast Construction of SAH-based Bounding Volume
 * Hierarchies, 2007). Boxes move together with their primitives, so that every pass reads memory in order. One object
 * serves range after range. All boxes are least x, y, z, then greatest x, y, z.
 */
final class SahSplitter {

    private static final int BINS = 16;

    /** Ranges shorter than this do with half as many. */
    private static final int FEW = 24;

    private final int[] primitives;
    private final float[] boxes;

    private final int[] counts = new int[BINS];
    private final float[][] bins = new float[BINS][6];
    private final float[] rightAreas = new float[BINS];

    // Of the current range: how many bins there are, along which axis, from where on, and how many for each unit.
    private int used;
    private int axis;
    private float min;
    private float binsPerUnit;

    /**
     * @param primitives primitives in some order, which splitting changes
     * @param boxes      6 numbers a primitive, in that order
     */
    SahSplitter(int[] primitives, float[] boxes) {
        this.primitives = primitives;
        this.boxes = boxes;
    }

    /**
     * Primitives {@code from} to {@code to - 1}.
     *
     * @param box     around them
     * @param centres the box around their boxes' centres, doubled: the sums of two opposite sides
     */
    record Range(int from, int to, float[] box, float[] centres) {

        int size() {
            return to - from;
        }

        float area() {
            return SahSplitter.area(box);
        }
    }

    Range range(int from, int to) {
        float[] box = new float[6], centres = new float[6];
        for (int side = 0; side < 3; side++) {
            float low = Float.POSITIVE_INFINITY, high = -low, lowCentre = low, highCentre = high;
            for (int i = 6 * from + side; i < 6 * to; i += 6) {
                float min = boxes[i], max = boxes[i + 3], centre = min + max;
                low = min < low ? min : low;
                high = max > high ? max : high;
                lowCentre = centre < lowCentre ? centre : lowCentre;
                highCentre = centre > highCentre ? centre : highCentre;
            }
            box[side] = low;
            box[side + 3] = high;
            centres[side] = lowCentre;
            centres[side + 3] = highCentre;
        }
        return new Range(from, to, box, centres);
    }

    /** Brings a range's primitives into the order of their side; returns where the second side starts, inside the range. */
    int split(Range range) {
        float[] c = range.centres;
        float x = c[3] - c[0], y = c[4] - c[1], z = c[5] - c[2];
        axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        min = c[axis];
        float spread = c[axis + 3] - min;
        if (!(spread > 0)) {
            // Centres that coincide: any half will do.
            return (range.from + range.to) >>> 1;
        }
        used = range.size() < FEW ? BINS / 2 : BINS;
        binsPerUnit = used / spread;
        fillBins(range);
        return partition(range, cheapest(range.size()));
    }

    private int bin(int box) {
        return Math.min(used - 1, (int) ((boxes[box + axis] + boxes[box + axis + 3] - min) * binsPerUnit));
    }

    private void fillBins(Range range) {
        for (int bin = 0; bin < used; bin++) {
            counts[bin] = 0;
            clear(bins[bin]);
        }
        for (int i = 6 * range.from; i < 6 * range.to; i += 6) {
            int bin = bin(i);
            counts[bin]++;
            extend(bins[bin], boxes, i);
        }
    }

    /** The first bin of the right side for which the sum of both sides' count times surface is least. */
    private int cheapest(int all) {
        float[] right = emptyBox(), left = emptyBox();
        for (int bin = used - 1; bin > 0; bin--) {
            extend(right, bins[bin], 0);
            rightAreas[bin] = area(right);
        }
        int best = 0;
        float least = Float.POSITIVE_INFINITY;
        int before = 0;
        for (int bin = 1; bin < used; bin++) {
            extend(left, bins[bin - 1], 0);
            before += counts[bin - 1];
            if (before > 0 && before < all) {
                float cost = area(left) * before + rightAreas[bin] * (all - before);
                if (cost < least) {
                    least = cost;
                    best = bin;
                }
            }
        }
        return best;
    }

    private int partition(Range range, int firstRight) {
        int i = range.from;
        int j = range.to;
        while (true) {
            while (i < j && bin(6 * i) < firstRight) {
                i++;
            }
            while (i < j && bin(6 * (j - 1)) >= firstRight) {
                j--;
            }
            if (i == j) {
                return i;
            }
            swap(i++, --j);
        }
    }

    private void swap(int i, int j) {
        int primitive = primitives[i];
        primitives[i] = primitives[j];
        primitives[j] = primitive;
        for (int side = 0; side < 6; side++) {
            int a = 6 * i + side, b = 6 * j + side;
            float value = boxes[a];
            boxes[a] = boxes[b];
            boxes[b] = value;
        }
    }

    private static float[] emptyBox() {
        float[] box = new float[6];
        clear(box);
        return box;
    }

    private static void clear(float[] box) {
        Arrays.fill(box, 0, 3, Float.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Float.NEGATIVE_INFINITY);
    }

    private static void extend(float[] box, float[] from, int i) {
        box[0] = Math.min(box[0], from[i]);
        box[1] = Math.min(box[1], from[i + 1]);
        box[2] = Math.min(box[2], from[i + 2]);
        box[3] = Math.max(box[3], from[i + 3]);
        box[4] = Math.max(box[4], from[i + 4]);
        box[5] = Math.max(box[5], from[i + 5]);
    }

    /** Half of a box's surface; 0 for an empty box. */
    private static float area(float[] box) {
        float x = box[3] - box[0], y = box[4] - box[1], z = box[5] - box[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
}
