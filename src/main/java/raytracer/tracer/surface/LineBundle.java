package raytracer.tracer.surface;

import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Vectors;

/**
 * The lines of a batch's rays in floats, seen from a point near all of them, as far as they differ: lines that meet differ in
 * direction, parallel ones in where they start, and others in both, as their moments tell (Pluecker coordinates).
 */
public final class LineBundle {

    private final float[] x = new float[Batch.CAPACITY], y = new float[Batch.CAPACITY], z = new float[Batch.CAPACITY];
    private final float[] momentX = new float[Batch.CAPACITY], momentY = new float[Batch.CAPACITY];
    private final float[] momentZ = new float[Batch.CAPACITY];

    // Bounds on how far off rays start, and on the errors of their directions' coordinates.
    public double originError;
    public double directionError;

    private Vector centre;
    private double spread;

    /** The direction of parallel lines, or null. */
    private Vector way;

    private boolean meet;

    /** Takes lines that all go through one point. */
    public void setMeeting(Vector point, Vectors origin, Vectors direction, int from, int to) {
        set(point, null, true, origin, from, to);
        round(direction, Vector.ZERO, 1, from, to);
    }

    /** Takes lines of one direction. */
    public void setParallel(Vector direction, Vectors origin, int from, int to) {
        set(origin.get(from), direction, false, origin, from, to);
        round(origin, centre, 1 / spread, from, to);
    }

    /** Takes any lines. */
    public void set(Vectors origin, Vectors direction, int from, int to) {
        set(origin.get(from), null, false, origin, from, to);
        round(direction, Vector.ZERO, 1, from, to);
        double cx = centre.x(), cy = centre.y(), cz = centre.z(), unit = 1 / spread;
        double[] dx = direction.x(), dy = direction.y(), dz = direction.z();
        for (int i = from; i < to; i++) {
            double ox = (origin.x()[i] - cx) * unit, oy = (origin.y()[i] - cy) * unit, oz = (origin.z()[i] - cz) * unit;
            momentX[i] = (float) (oy * dz[i] - oz * dy[i]);
            momentY[i] = (float) (oz * dx[i] - ox * dz[i]);
            momentZ[i] = (float) (ox * dy[i] - oy * dx[i]);
        }
    }

    private void set(Vector seenFrom, Vector direction, boolean allMeet, Vectors origin, int from, int to) {
        centre = seenFrom;
        way = direction;
        meet = allMeet;
        spread = farthest(origin.x(), centre.x(), from, to) + farthest(origin.y(), centre.y(), from, to)
                + farthest(origin.z(), centre.z(), from, to) + Double.MIN_NORMAL;
    }

    /** In whole numbers, which compare like doubles that are not negative, but without a branch. */
    private static double farthest(double[] values, double from, int first, int to) {
        long max = 0;
        for (int i = first; i < to; i++) {
            max = Math.max(max, Double.doubleToRawLongBits(Math.abs(values[i] - from)));
        }
        return Double.longBitsToDouble(max);
    }

    /** The greatest magnitude among numbers; NaN if one is. */
    public static double max(double[] values, int from, int to) {
        return farthest(values, 0, from, to);
    }

    private void round(Vectors vectors, Vector from, double unit, int first, int to) {
        round(vectors.x(), from.x(), unit, x, first, to);
        round(vectors.y(), from.y(), unit, y, first, to);
        round(vectors.z(), from.z(), unit, z, first, to);
    }

    private static void round(double[] values, double from, double unit, float[] out, int first, int to) {
        for (int i = first; i < to; i++) {
            out[i] = (float) ((values[i] - from) * unit);
        }
    }

    /** From where the lines are seen. */
    public Vector centre() {
        return centre;
    }

    /** |x| + |y| + |z| of the farthest ray's origin, as seen from there, or more. */
    public double spread() {
        return spread;
    }

    /** Whether all go through the point that they are seen from. */
    public boolean meet() {
        return meet;
    }

    /** Whether they meet or are parallel. */
    public boolean areAlike() {
        return meet || way != null;
    }

    /**
     * Of lines that are alike, what an edge's side is linear in, with {@link #constant}: the side is this times the direction
     * of lines that meet, or the origin of parallel ones, as seen from the centre.
     */
    public Vector normal(Vector edge, Vector sum) {
        // e . (o x d) = o . (d x e)
        return way != null ? way.cross(edge).times(-2) : edge.cross(sum);
    }

    public double constant(Vector edge, Vector sum) {
        return way != null ? way.dot(edge.cross(sum)) : 0;
    }

    /**
     * By line, the side of an edge in floats: direction . (edge x sum of its ends as seen from the ray's origin).
     *
     * @param sum   of the ends as seen from the centre
     * @param scale what sides are multiplied by: with 1 / (edge times distance) no number is far from 1
     */
    public void side(Vector edge, Vector sum, double scale, float[] out, int from, int to) {
        if (way != null) {
            dot(normal(edge, sum).times(scale * spread), scale * constant(edge, sum), out, from, to);
            return;
        }
        dot(edge.cross(sum).times(scale), 0, out, from, to);
        if (!meet) {
            addDot(edge.times(-2 * scale * spread), out, from, to);
        }
    }

    private void dot(Vector v, double constant, float[] out, int from, int to) {
        float[] x = this.x, y = this.y, z = this.z;
        float vx = (float) v.x(), vy = (float) v.y(), vz = (float) v.z(), c = (float) constant;
        for (int i = from; i < to; i++) {
            out[i] = x[i] * vx + y[i] * vy + z[i] * vz + c;
        }
    }

    private void addDot(Vector v, float[] out, int from, int to) {
        float[] mx = momentX, my = momentY, mz = momentZ;
        float vx = (float) v.x(), vy = (float) v.y(), vz = (float) v.z();
        for (int i = from; i < to; i++) {
            out[i] += mx[i] * vx + my[i] * vy + mz[i] * vz;
        }
    }
}
