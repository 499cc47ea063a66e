package raytracer.tracer.bvh;

import java.util.Arrays;

/**
 * Splits ranges of primitives in two by the surface area heuristic: along the axis on which the boxes' centres spread
 * most, at the best of the limits between {@link #BINS} bins (Wald, On fast Construction of SAH-based Bounding Volume
 * Hierarchies, 2007). Boxes move together with their primitives, so that every pass reads memory in order. One object
 * serves range after range.
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
    private int used;
    private float[] left;
    private float[] right;

    /**
     * @param primitives primitives in some order, which splitting changes
     * @param boxes      6 numbers a primitive, in that order
     */
    SahSplitter(int[] primitives, float[] boxes) {
        this.primitives = primitives;
        this.boxes = boxes;
    }

    /**
     * Brings a range's primitives into the order of their side; returns where the second side starts, inside the
     * range.
     */
    int at(int from, int to) {
        left = new float[6];
        right = new float[6];
        float[] centres = centres(from, to);
        int axis = widest(centres);
        float min = centres[axis];
        float spread = centres[axis + 3] - min;
        if (!(spread > 0)) {
            return halve(from, to);
        }
        used = to - from < FEW ? BINS / 2 : BINS;
        float binsPerUnit = used / spread;
        fillBins(from, to, axis, min, binsPerUnit);
        int bin = cheapest(to - from);
        merge(0, bin, left);
        merge(bin, used, right);
        return partition(from, to, axis, min, binsPerUnit, bin);
    }

    float[] leftBox() {
        return left;
    }

    float[] rightBox() {
        return right;
    }

    float leftArea() {
        return area(left);
    }

    float rightArea() {
        return area(right);
    }

    /** Primitives whose centres coincide: any half will do. */
    private int halve(int from, int to) {
        int middle = (from + to) >>> 1;
        enclose(from, middle, left);
        enclose(middle, to, right);
        return middle;
    }

    private void enclose(int from, int to, float[] box) {
        clear(box);
        for (int i = from; i < to; i++) {
            extend(box, boxes, 6 * i);
        }
    }

    /** The least and the greatest centres, doubled: the sums of two opposite sides. */
    private float[] centres(int from, int to) {
        float minX = Float.POSITIVE_INFINITY, minY = minX, minZ = minX;
        float maxX = Float.NEGATIVE_INFINITY, maxY = maxX, maxZ = maxX;
        for (int i = 6 * from; i < 6 * to; i += 6) {
            float x = boxes[i] + boxes[i + 3], y = boxes[i + 1] + boxes[i + 4], z = boxes[i + 2] + boxes[i + 5];
            minX = x < minX ? x : minX;
            minY = y < minY ? y : minY;
            minZ = z < minZ ? z : minZ;
            maxX = x > maxX ? x : maxX;
            maxY = y > maxY ? y : maxY;
            maxZ = z > maxZ ? z : maxZ;
        }
        return new float[] {minX, minY, minZ, maxX, maxY, maxZ};
    }

    private static int widest(float[] box) {
        float x = box[3] - box[0], y = box[4] - box[1], z = box[5] - box[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    private int bin(int box, int axis, float min, float binsPerUnit) {
        return Math.min(used - 1, (int) ((boxes[box + axis] + boxes[box + axis + 3] - min) * binsPerUnit));
    }

    private void fillBins(int from, int to, int axis, float min, float binsPerUnit) {
        for (int bin = 0; bin < used; bin++) {
            counts[bin] = 0;
            clear(bins[bin]);
        }
        for (int i = 6 * from; i < 6 * to; i += 6) {
            int bin = bin(i, axis, min, binsPerUnit);
            counts[bin]++;
            extend(bins[bin], boxes, i);
        }
    }

    /** The first bin of the right side for which the sum of both sides' count times surface is least. */
    private int cheapest(int all) {
        float[] box = new float[6];
        clear(box);
        for (int bin = used - 1; bin > 0; bin--) {
            extend(box, bins[bin], 0);
            rightAreas[bin] = area(box);
        }
        clear(box);
        int best = 0;
        float min = Float.POSITIVE_INFINITY;
        int before = 0;
        for (int bin = 1; bin < used; bin++) {
            extend(box, bins[bin - 1], 0);
            before += counts[bin - 1];
            if (before > 0 && before < all) {
                float cost = area(box) * before + rightAreas[bin] * (all - before);
                if (cost < min) {
                    min = cost;
                    best = bin;
                }
            }
        }
        return best;
    }

    private int partition(int from, int to, int axis, float min, float binsPerUnit, int firstRight) {
        int i = from;
        int j = to;
        while (true) {
            while (i < j && bin(6 * i, axis, min, binsPerUnit) < firstRight) {
                i++;
            }
            while (i < j && bin(6 * (j - 1), axis, min, binsPerUnit) >= firstRight) {
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

    private void merge(int fromBin, int toBin, float[] box) {
        clear(box);
        for (int bin = fromBin; bin < toBin; bin++) {
            extend(box, bins[bin], 0);
        }
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
