package raytracer.tracer.primitive;

import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.RayIntervals;
import raytracer.tracer.surface.LineBundle;
import raytracer.tracer.surface.Workspace;

/**
 * Tells of a batch's rays which clearly pass edges of a triangle on different sides, as {@link TriangleArray#within} has
 * sides, but in floats and about one point, for which a triangle's part is the same for all rays. Sides are in parts of edge
 * times distance.
 */
final class EdgeSides {

    /**
     * Bounds what floats round a side by, in that unit: the products' magnitudes add up to 4 at most, and each rounds by
     * 2^-24 seven times; half as much again for the difference of two.
     */
    private static final double FLOATS = 0x1p-18;

    private final TriangleArray data;

    EdgeSides(TriangleArray data) {
        this.data = data;
    }

    /**
     * Keeps, of some triangles' numbers, those that a line of the bundle may hit, if its rays lie in these intervals.
     *
     * @return how many are kept
     */
    int sift(RayIntervals rays, LineBundle lines, int[] numbers, int count) {
        if (!lines.areAlike()) {
            return count;
        }
        int kept = 0;
        for (int n = 0; n < count; n++) {
            if (mayHit(rays, lines, numbers[n])) {
                numbers[kept++] = numbers[n];
            }
        }
        return kept;
    }

    /**
     * Computes by ray how far two edges' sides are apart, twice, where they differ, in {@link Workspace#clearance}.
     *
     * @return rays are clear of the triangle that have more than this
     */
    float measure(int from, int to, int k, Workspace workspace) {
        LineBundle lines = workspace.lines;
        Vector centre = lines.centre();
        Vector a = data.corner(k, 0).minus(centre), b = data.corner(k, 1).minus(centre), c = data.corner(k, 2).minus(centre);
        double edges = data.edges(k), l1Norm = a.l1Norm() + edges + lines.spread(), scale = 1 / (edges * l1Norm);
        side(lines, a, b, scale, workspace.ab, from, to);
        side(lines, b, c, scale, workspace.bc, from, to);
        side(lines, c, a, scale, workspace.ca, from, to);
        differ(workspace.ab, workspace.bc, workspace.clearance, from, to);
        differ(workspace.bc, workspace.ca, workspace.bc, from, to);
        differ(workspace.ca, workspace.ab, workspace.ab, from, to);
        max(workspace.clearance, workspace.bc, from, to);
        max(workspace.ab, workspace.ab, from, to);
        max(workspace.clearance, workspace.ab, from, to);
        return (float) (8 * bound(lines, l1Norm));
    }

    private static void side(LineBundle lines, Vector a, Vector b, double scale, float[] out, int from, int to) {
        lines.side(b.minus(a), a.minus(b.times(-1)), scale, out, from, to);
    }

    /** Of two numbers of different signs, the difference exceeds the sum by twice the smaller one. */
    private static void differ(float[] a, float[] b, float[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.abs(a[i] - b[i]) - Math.abs(a[i] + b[i]);
        }
    }

    /** Replaces a number by twice the greater one of two; by magnitudes, as HotSpot makes no vectors of maxima of floats. */
    private static void max(float[] a, float[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] = a[i] + b[i] + Math.abs(a[i] - b[i]);
        }
    }

    private static double bound(LineBundle lines, double l1Norm) {
        return FLOATS + 2 * Rounding.edge(lines.originError, lines.directionError, l1Norm, 1) / l1Norm;
    }

    private boolean mayHit(RayIntervals rays, LineBundle lines, int k) {
        Vector centre = lines.centre(), a = data.corner(k, 0).minus(centre), first = a;
        double edges = data.edges(k), l1Norm = a.l1Norm() + edges + lines.spread();
        double bound = edges * l1Norm * bound(lines, l1Norm) * (lines.meet() ? rays.maxDirectionNorm() : 1);
        boolean isLeft = false, isRight = false;
        for (int edge = 0; edge < 3; edge++) {
            Vector b = edge == 2 ? first : data.corner(k, edge + 1).minus(centre), e = b.minus(a), sum = a.minus(b.times(-1));
            Vector normal = lines.normal(e, sum);
            double constant = lines.constant(e, sum);
            isLeft |= constant + min(rays, lines, normal) > bound;
            isRight |= constant - min(rays, lines, normal.times(-1)) < -bound;
            a = b;
        }
        return !(isLeft && isRight);
    }

    /** The least product of a vector with what lines differ in. */
    private static double min(RayIntervals rays, LineBundle lines, Vector v) {
        if (lines.meet()) {
            return RayIntervals.min(rays.minDirection, rays.maxDirection, v);
        }
        return RayIntervals.min(rays.minOrigin, rays.maxOrigin, v) - lines.centre().dot(v);
    }
}
