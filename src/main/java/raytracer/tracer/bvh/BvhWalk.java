package raytracer.tracer.bvh;

import java.util.Arrays;

/**
 * One ray's way through a {@link Bvh}: the leaves whose boxes it hits, the nearest of a node's children first. One
 * object serves ray after ray.
 */
public final class BvhWalk {

    /** Stands for the reciprocal of a direction's component that is 0 or nearly: finite, so that no NaN can arise. */
    private static final float STEEPEST = 1e30f;

    /** What a child's key is when the ray misses it; above all others. */
    private static final int MISSED = Integer.MAX_VALUE;

    /** Of a key: which of a node's children it is. */
    private static final int WHICH = Bvh.WIDTH - 1;

    private Bvh bvh;

    // In tree space: how far along the ray it was taken up, and where that is.
    public double start;
    public double x, y, z;

    // The current leaf's first primitive, and behind its last.
    public int first;
    public int end;

    // The reciprocal of the direction, its magnitude, that negated (C2 would take an instruction to negate the other
    // factor), and the origin times the reciprocal, negated.
    private float ix, iy, iz;
    private float aix, aiy, aiz;
    private float naix, naiy, naiz;
    private float noix, noiy, noiz;

    /** What is still to be visited: the bits of the box's distance (a float, not negative) above a child's number. */
    private long[] stack = new long[64];
    private int stacked;

    /**
     * Sets out on a ray; the direction is a unit vector.
     *
     * @return false if the ray passes by the tree
     */
    public boolean start(Bvh tree, double ox, double oy, double oz, double dx, double dy, double dz) {
        bvh = tree;
        stacked = 0;
        if (tree.root() == Bvh.EMPTY) {
            return false;
        }
        x = tree.space().x(ox);
        y = tree.space().y(oy);
        z = tree.space().z(oz);
        start = 0;
        if (Math.abs(x) > 1 || Math.abs(y) > 1 || Math.abs(z) > 1) {
            // Floats only hold up near the tree, so the ray is taken to the cube around it first, in double.
            start = entry(x, y, z, dx, dy, dz);
            if (!(start < Double.POSITIVE_INFINITY)) {
                return false;
            }
            x += start * dx;
            y += start * dy;
            z += start * dz;
        }
        ix = reciprocal(dx);
        iy = reciprocal(dy);
        iz = reciprocal(dz);
        aix = Math.abs(ix);
        aiy = Math.abs(iy);
        aiz = Math.abs(iz);
        naix = -aix;
        naiy = -aiy;
        naiz = -aiz;
        noix = -((float) x * ix);
        noiy = -((float) y * iy);
        noiz = -((float) z * iz);
        stack[stacked++] = tree.root() & 0xFFFFFFFFL;
        return true;
    }

    /** Leaves out all of the tree but one node or leaf; to be called before the first leaf is taken. */
    public void enter(int child) {
        stack[0] = child & 0xFFFFFFFFL;
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
     * Goes to the next leaf. The oversized primitives are in none.
     *
     * @param limit no box farther away matters, in world space; may shrink from call to call
     * @return false if there is no more
     */
    public boolean nextLeaf(double limit) {
        // Rounded up by more than floats round: the padding has room for it.
        float maxDistance = (float) ((limit * bvh.space().scale() - start) * (1 + 0x1p-22));
        int maxBits = Float.floatToRawIntBits(maxDistance);
        while (stacked > 0) {
            long key = stack[--stacked];
            if ((int) (key >>> 32) > maxBits) {
                continue;
            }
            int child = (int) key;
            if (child < 0) {
                first = Bvh.leafFirst(child);
                end = Bvh.leafEnd(child);
                return true;
            }
            visit(child);
        }
        return false;
    }

    /** Puts down all children that the ray hits: whether they are in reach is asked when they are taken up. */
    private void visit(int node) {
        float[] nodes = bvh.nodes();
        int at = node * Bvh.NODE_STRIDE;
        int a0 = key(nodes, at, 0), a1 = key(nodes, at, 1);
        int a2 = key(nodes, at, 2), a3 = key(nodes, at, 3);
        // Three exchanges bring the nearest to the top; sorting all took longer than it saved. Misses are overwritten.
        int b0 = Math.min(a0, a1), b1 = Math.max(a0, a1), b2 = Math.min(a2, a3), b3 = Math.max(a2, a3);
        int c0 = Math.min(b0, b2), c2 = Math.max(b0, b2);
        grow();
        long[] s = stack;
        int n = stacked;
        s[n] = toVisit(nodes, at, b3);
        n += b3 - MISSED >>> 31;
        s[n] = toVisit(nodes, at, b1);
        n += b1 - MISSED >>> 31;
        s[n] = toVisit(nodes, at, c2);
        n += c2 - MISSED >>> 31;
        s[n] = toVisit(nodes, at, c0);
        n += c0 - MISSED >>> 31;
        stacked = n;
    }

    private static long toVisit(float[] nodes, int at, int key) {
        return (long) key << 32 | Float.floatToRawIntBits(nodes[at + Bvh.CHILD + (key & WHICH)]) & 0xFFFFFFFFL;
    }

    private void grow() {
        if (stacked + Bvh.WIDTH > stack.length) {
            stack = Arrays.copyOf(stack, 2 * stack.length);
        }
    }

    /**
     * How far away a child's box is, and in the two lowest bits which child that is; or {@link #MISSED}. Floats that
     * are not negative compare like their bits, and negative floats have negative bits: so ints decide, without the
     * care for NaN that floats' min and max would take, and without a branch, which would be mispredicted half of the
     * time. Boxes are told by middle and half width, for then near and far are where they are for any direction.
     */
    private int key(float[] nodes, int node, int child) {
        int at = node + child;
        float x = Math.fma(nodes[at], ix, noix);
        float y = Math.fma(nodes[at + Bvh.AXIS_STRIDE], iy, noiy);
        float z = Math.fma(nodes[at + 2 * Bvh.AXIS_STRIDE], iz, noiz);
        float halfX = nodes[at + Bvh.HALF];
        float halfY = nodes[at + Bvh.AXIS_STRIDE + Bvh.HALF];
        float halfZ = nodes[at + 2 * Bvh.AXIS_STRIDE + Bvh.HALF];
        int nearX = Float.floatToRawIntBits(Math.fma(halfX, naix, x));
        int nearY = Float.floatToRawIntBits(Math.fma(halfY, naiy, y));
        int nearZ = Float.floatToRawIntBits(Math.fma(halfZ, naiz, z));
        int farX = Float.floatToRawIntBits(Math.fma(halfX, aix, x));
        int farY = Float.floatToRawIntBits(Math.fma(halfY, aiy, y));
        int farZ = Float.floatToRawIntBits(Math.fma(halfZ, aiz, z));
        int near = Math.max(Math.max(nearX, nearY), Math.max(nearZ, 0));
        int far = Math.min(Math.min(farX, farY), farZ);
        // Negative if far is, or if it is before near.
        int missed = (far - near | far) >> 31;
        return near & ~WHICH | child | missed & MISSED;
    }
}
