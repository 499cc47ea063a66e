package raytracer.tracer.primitive;

import raytracer.scene.Mesh;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.TreeSpace;
import raytracer.tracer.surface.SieveLine;

/**
 * Tells quickly that a ray's line clearly passes a triangle by: floats, few of them, and no branch. Each triangle is
 * 16 numbers in the space of its {@link Bvh}: two edges, a x b, b x c and a x c of its corners, and a bound on what an
 * edge is long. The side on which a line passes an edge is direction . (a x b) + moment . (b - a) (Pluecker
 * coordinates; Shevtsov, Soupikov and Kapustin, Ray-Triangle Intersection Algorithm for Modern CPU Architectures,
 * 2007, who decide by it; here it only sorts out).
 */
final class TriangleSieve {

    private static final int STRIDE = 16;

    /**
     * An edge's bound is no less: of shorter ones a side is off by more because corners are rounded by u in tree space,
     * 12u in all, which is less than this times what floats' rounding is taken for.
     */
    private static final float SHORTEST = 0x1p-29f;

    private final float[] numbers;

    /** @param bvh of all triangles of the mesh: lines will come in its space */
    TriangleSieve(Mesh mesh, Bvh bvh) {
        int[] order = bvh.order();
        TreeSpace space = bvh.space();
        numbers = new float[Math.multiplyExact(STRIDE, order.length)];
        for (int k = 0; k < order.length; k++) {
            set(STRIDE * k, space.of(mesh.corner(order[k], 0)), space.of(mesh.corner(order[k], 1)),
                    space.of(mesh.corner(order[k], 2)));
        }
    }

    private void set(int at, Vector a, Vector b, Vector c) {
        Vector ab = b.minus(a), bc = c.minus(b);
        set(at, ab);
        set(at + 3, bc);
        set(at + 6, a.cross(b));
        set(at + 9, b.cross(c));
        set(at + 12, a.cross(c));
        numbers[at + 15] = Math.max((float) (ab.l1Norm() + bc.l1Norm()), SHORTEST);
    }

    private void set(int at, Vector v) {
        numbers[at] = (float) v.x();
        numbers[at + 1] = (float) v.y();
        numbers[at + 2] = (float) v.z();
    }

    /**
     * Which of some triangles a line may pass with all edges on one side, a bit for each, the first one's lowest: it
     * does if {@link Triangles} says so.
     *
     * @param end at most 32 behind the first
     */
    int mayHit(SieveLine line, int first, int end) {
        int bits = 0;
        for (int k = first; k < end; k++) {
            bits |= ~clear(line, k) >>> 31 << k - first;
        }
        return bits;
    }

    /** Negative if a line clearly passes edges of triangle k on different sides. */
    private int clear(SieveLine line, int k) {
        float[] n = numbers;
        int at = STRIDE * k;
        float mx = line.momentX, my = line.momentY, mz = line.momentZ, dx = line.dx, dy = line.dy, dz = line.dz;
        float first = Math.fma(mx, n[at], Math.fma(my, n[at + 1], mz * n[at + 2]));
        float second = Math.fma(mx, n[at + 3], Math.fma(my, n[at + 4], mz * n[at + 5]));
        float ab = Math.fma(dx, n[at + 6], Math.fma(dy, n[at + 7], Math.fma(dz, n[at + 8], first)));
        float bc = Math.fma(dx, n[at + 9], Math.fma(dy, n[at + 10], Math.fma(dz, n[at + 11], second)));
        float ac = Math.fma(dx, n[at + 12], Math.fma(dy, n[at + 13], Math.fma(dz, n[at + 14], first + second)));
        float bound = n[at + 15] * line.tolerance;
        // The sign bits of what is clearly on one side, and clearly on the other.
        int left = Float.floatToRawIntBits(ab + bound) | Float.floatToRawIntBits(bc + bound)
                | Float.floatToRawIntBits(bound - ac);
        int right = Float.floatToRawIntBits(bound - ab) | Float.floatToRawIntBits(bound - bc)
                | Float.floatToRawIntBits(ac + bound);
        return left & right;
    }
}
