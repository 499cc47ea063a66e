package raytracer.tracer;

import java.util.Arrays;

/**
 * One ray's way through a {@link Bvh}: the leaves whose boxes it meets, nearest boxes first. One object serves ray
 * after ray.
 */
final class BvhWalk {

    /** Stands for the reciprocal of a direction's component that is 0 or nearly: finite, so that no NaN can arise. */
    private static final float STEEPEST = 1e30f;

    /** What a child's key is when the ray misses it; above all others. */
    private static final long MISSED = Long.MAX_VALUE;

    private Bvh bvh;
    private double start;
    private float ix, iy, iz;
    private float oix, oiy, oiz;
    private int nearX, nearY, nearZ;

    /** What is still to be visited: the bits of the box's distance (a float, not negative) above a child's number. */
    private long[] stack = new long[64];
    private int stacked;
    private int first;
    private int end;

    /** Sets out on a ray; the direction is a unit vector. */
    void start(Bvh tree, double ox, double oy, double oz, double dx, double dy, double dz) {
        bvh = tree;
        stacked = 0;
        if (tree.root() == Bvh.EMPTY) {
            return;
        }
        double x = (ox - tree.centreX()) * tree.scale();
        double y = (oy - tree.centreY()) * tree.scale();
        double z = (oz - tree.centreZ()) * tree.scale();
        start = 0;
        if (Math.abs(x) > 1 || Math.abs(y) > 1 || Math.abs(z) > 1) {
            // Floats only hold up near the tree, so the ray is taken to the cube around it first, in double.
            start = entry(x, y, z, dx, dy, dz);
            if (!(start < Double.POSITIVE_INFINITY)) {
                return;
            }
            x += start * dx;
            y += start * dy;
            z += start * dz;
        }
        ix = reciprocal(dx);
        iy = reciprocal(dy);
        iz = reciprocal(dz);
        oix = (float) x * ix;
        oiy = (float) y * iy;
        oiz = (float) z * iz;
        nearX = ix < 0 ? Bvh.WIDTH : 0;
        nearY = (iy < 0 ? Bvh.WIDTH : 0) + 2 * Bvh.WIDTH;
        nearZ = (iz < 0 ? Bvh.WIDTH : 0) + 4 * Bvh.WIDTH;
        stack[stacked++] = tree.root() & 0xFFFFFFFFL;
    }

    private static float reciprocal(double d) {
        float reciprocal = (float) (1 / d);
        return Math.abs(reciprocal) <= STEEPEST ? reciprocal : Math.copySign(STEEPEST, reciprocal);
    }

    /** Where a ray from outside enters the cube from -1 to 1, a little enlarged; infinite if it does not. */
    private static double entry(double x, double y, double z, double dx, double dy, double dz) {
        double cube = 1 + Bvh.PADDING;
        double near = Math.max(Math.max(slabNear(x, dx, cube), slabNear(y, dy, cube)), slabNear(z, dz, cube));
        double far = Math.min(Math.min(slabFar(x, dx, cube), slabFar(y, dy, cube)), slabFar(z, dz, cube));
        return near <= far && far >= 0 ? Math.max(near, 0) : Double.POSITIVE_INFINITY;
    }

    private static double slabNear(double o, double d, double cube) {
        if (d == 0) {
            return Math.abs(o) <= cube ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
        }
        return (d > 0 ? -cube - o : cube - o) / d;
    }

    private static double slabFar(double o, double d, double cube) {
        return d == 0 ? Double.POSITIVE_INFINITY : (d > 0 ? cube - o : -cube - o) / d;
    }

    /**
     * Goes to the next leaf. The things beside the tree are in none.
     *
     * @param limit no box farther away matters, in world space; may shrink from call to call
     * @return false if there is no more
     */
    boolean nextLeaf(double limit) {
        // Rounded up by more than floats round: the padding has room for it.
        float reach = (float) ((limit * bvh.scale() - start) * (1 + 0x1p-22));
        int reachBits = Float.floatToRawIntBits(reach);
        while (stacked > 0) {
            long key = stack[--stacked];
            if ((int) (key >>> 32) > reachBits) {
                continue;
            }
            int child = (int) key;
            if (child < 0) {
                first = Bvh.leafFirst(child);
                end = Bvh.leafEnd(child);
                return true;
            }
            visit(child, reachBits);
        }
        return false;
    }

    /** The current leaf's first thing. */
    int first() {
        return first;
    }

    /** Behind the current leaf's last thing. */
    int end() {
        return end;
    }

    private void visit(int node, int reachBits) {
        float[] boxes = bvh.boxes();
        int[] children = bvh.children();
        int x = node * Bvh.BOX_STRIDE + nearX, y = node * Bvh.BOX_STRIDE + nearY, z = node * Bvh.BOX_STRIDE + nearZ;
        // On each axis the far planes are where the near ones would be for the opposite direction.
        int fx = node * Bvh.BOX_STRIDE + Bvh.WIDTH - nearX;
        int fy = node * Bvh.BOX_STRIDE + 5 * Bvh.WIDTH - nearY;
        int fz = node * Bvh.BOX_STRIDE + 9 * Bvh.WIDTH - nearZ;
        int c = node * Bvh.WIDTH;
        long a0 = key(boxes, x, y, z, fx, fy, fz, reachBits, children[c]);
        long a1 = key(boxes, x + 1, y + 1, z + 1, fx + 1, fy + 1, fz + 1, reachBits, children[c + 1]);
        long a2 = key(boxes, x + 2, y + 2, z + 2, fx + 2, fy + 2, fz + 2, reachBits, children[c + 2]);
        long a3 = key(boxes, x + 3, y + 3, z + 3, fx + 3, fy + 3, fz + 3, reachBits, children[c + 3]);
        // A sorting network of five exchanges, then the farthest goes down first; misses are overwritten.
        long b0 = Math.min(a0, a1), b1 = Math.max(a0, a1), b2 = Math.min(a2, a3), b3 = Math.max(a2, a3);
        long c0 = Math.min(b0, b2), c2 = Math.max(b0, b2), c1 = Math.min(b1, b3), c3 = Math.max(b1, b3);
        long d1 = Math.min(c1, c2), d2 = Math.max(c1, c2);
        if (stacked + Bvh.WIDTH > stack.length) {
            stack = Arrays.copyOf(stack, 2 * stack.length);
        }
        long[] s = stack;
        int n = stacked;
        s[n] = c3;
        n += c3 != MISSED ? 1 : 0;
        s[n] = d2;
        n += d2 != MISSED ? 1 : 0;
        s[n] = d1;
        n += d1 != MISSED ? 1 : 0;
        s[n] = c0;
        n += c0 != MISSED ? 1 : 0;
        stacked = n;
    }

    /**
     * Floats that are not negative compare like their bits, and negative floats have negative bits: so ints decide,
     * without the care for NaN that floats' min and max would take.
     */
    private long key(float[] boxes, int x, int y, int z, int fx, int fy, int fz, int reachBits, int child) {
        int nx = Float.floatToRawIntBits(Math.fma(boxes[x], ix, -oix));
        int ny = Float.floatToRawIntBits(Math.fma(boxes[y], iy, -oiy));
        int nz = Float.floatToRawIntBits(Math.fma(boxes[z], iz, -oiz));
        int farX = Float.floatToRawIntBits(Math.fma(boxes[fx], ix, -oix));
        int farY = Float.floatToRawIntBits(Math.fma(boxes[fy], iy, -oiy));
        int farZ = Float.floatToRawIntBits(Math.fma(boxes[fz], iz, -oiz));
        int near = Math.max(Math.max(nx, ny), Math.max(nz, 0));
        int far = Math.min(Math.min(farX, farY), Math.min(farZ, reachBits));
        return near <= far ? (long) near << 32 | child & 0xFFFFFFFFL : MISSED;
    }
}
