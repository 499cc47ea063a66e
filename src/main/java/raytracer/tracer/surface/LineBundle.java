package raytracer.tracer.surface;

import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.RayIntervals;

/**
 * The lines of a batch's rays in floats, seen from a point near all of them, as far as they differ: lines that meet differ in
 * direction, parallel ones in where they start, and others in both, as their moments tell (Pluecker coordinates). The side on
 * which a line passes an edge is linear in these, so loops that C2 makes vectors of tell which lines clearly pass two edges of
 * a triangle on different sides.
 */
public final class LineBundle {

    /**
     * Bounds what floats round a side by, in parts of edge times distance: the products' magnitudes add up to 4 at most, and
     * each rounds by 2^-24 seven times; half as much again for the comparison of two.
     */
    private static final double FLOATS = 0x1p-18;

    /** A loop over lines. All kinds are called in one place, where HotSpot then inlines none: so it compiles each once. */
    private interface Loop {

        void run(float[] a, float[] b, float[] out, int from, int to);
    }

    private final Loop dot = (a, b, out, from, to) -> dot(out, from, to);
    private final Loop addMoments = (a, b, out, from, to) -> addMoments(out, from, to);
    private final Loop differ = (a, b, out, from, to) -> differ(a, b, out, from, to);
    private final Loop max = (a, b, out, from, to) -> max(a, out, from, to);

    private final float[] x = new float[Batch.CAPACITY], y = new float[Batch.CAPACITY], z = new float[Batch.CAPACITY];
    private final float[] momentX = new float[Batch.CAPACITY], momentY = new float[Batch.CAPACITY];
    private final float[] momentZ = new float[Batch.CAPACITY];

    // By line: the sides of a triangle's edges.
    private final float[][] side = new float[3][Batch.CAPACITY];

    /** By line: by how much it passes two edges of the measured triangle on different sides. */
    public final float[] clearance = new float[Batch.CAPACITY];

    // Bounds on how far off rays start, and on the errors of their directions' coordinates.
    private double originError, directionError;

    private Vector centre;

    /** |x| + |y| + |z| of the farthest ray's origin, as seen from the centre, or more: the unit of parallel lines' origins. */
    private double spread;

    /** The direction of parallel lines, or null. */
    private Vector way;

    private boolean meet;

    // Of an edge: its side is this times what lines differ in, and this constant more; of skew lines, times their moments.
    private double nx, ny, nz, constant, mx, my, mz;

    // Intervals of what alike lines differ in, and the length of which a side is a part.
    private final double[] low = new double[3], high = new double[3];
    private double length;

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
    public void setSkew(Vectors origin, Vectors direction, int from, int to) {
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

    /** Sets bounds on the rays' errors. */
    public void setErrors(double ofOrigins, double ofDirections) {
        originError = ofOrigins;
        directionError = ofDirections;
    }

    /** The greatest magnitude among numbers; NaN if one is. */
    public static double max(double[] values, int from, int to) {
        return farthest(values, 0, from, to);
    }

    /** In whole numbers, which compare like doubles that are not negative, but without a branch. */
    private static double farthest(double[] values, double from, int first, int to) {
        long max = 0;
        for (int i = first; i < to; i++) {
            max = Math.max(max, Double.doubleToRawLongBits(Math.abs(values[i] - from)));
        }
        return Double.longBitsToDouble(max);
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

    /** Whether lines meet or are parallel. */
    public boolean areAlike() {
        return meet || way != null;
    }

    /** Takes lines that are alike for those of rays in these intervals. */
    public void setIntervals(RayIntervals rays) {
        double[] min = meet ? rays.minDirection : rays.minOrigin, max = meet ? rays.maxDirection : rays.maxOrigin;
        length = meet ? 0 : 1;
        for (int axis = 0; axis < 3; axis++) {
            double from = meet ? 0 : centre.coordinate(axis), unit = meet ? 1 : 1 / spread;
            low[axis] = (min[axis] - from) * unit;
            high[axis] = (max[axis] - from) * unit;
            length += meet ? Math.max(Math.abs(min[axis]), Math.abs(max[axis])) : 0;
        }
    }

    /** Whether a line in the intervals may hit a triangle. @param edges |x| + |y| + |z| of an edge at most */
    public boolean mayHit(Vector a, Vector b, Vector c, double edges) {
        double l1Norm = distance(a, edges), bound = bound(l1Norm) * length;
        setEdge(a, b, 1 / (edges * l1Norm));
        boolean isLeft = min() > bound, isRight = max() < -bound;
        setEdge(b, c, 1 / (edges * l1Norm));
        isLeft |= min() > bound;
        isRight |= max() < -bound;
        setEdge(c, a, 1 / (edges * l1Norm));
        return !((isLeft || min() > bound) && (isRight || max() < -bound));
    }

    private double min() {
        return constant + nx * (nx > 0 ? low[0] : high[0]) + ny * (ny > 0 ? low[1] : high[1])
                + nz * (nz > 0 ? low[2] : high[2]);
    }

    private double max() {
        return constant + nx * (nx > 0 ? high[0] : low[0]) + ny * (ny > 0 ? high[1] : low[1])
                + nz * (nz > 0 ? high[2] : low[2]);
    }

    /** How far a triangle is, at most, from where lines are seen and rays start. */
    private double distance(Vector corner, double edges) {
        return Math.abs(corner.x() - centre.x()) + Math.abs(corner.y() - centre.y()) + Math.abs(corner.z() - centre.z())
                + edges + spread;
    }

    private double bound(double l1Norm) {
        return FLOATS + 2 * Rounding.edge(originError, directionError, l1Norm, 1) / l1Norm;
    }

    /**
     * Sets what the side of the edge e from a to b is linear in: direction . (e x s), where s is the sum of the ends as seen
     * from the ray's origin o, is direction . (e x s) - 2 e . (o x direction) as all are seen from the centre.
     */
    private void setEdge(Vector a, Vector b, double scale) {
        double ex = (b.x() - a.x()) * scale, ey = (b.y() - a.y()) * scale, ez = (b.z() - a.z()) * scale;
        double sx = a.x() - centre.x() + (b.x() - centre.x()), sy = a.y() - centre.y() + (b.y() - centre.y());
        double sz = a.z() - centre.z() + (b.z() - centre.z());
        nx = ey * sz - ez * sy;
        ny = ez * sx - ex * sz;
        nz = ex * sy - ey * sx;
        constant = 0;
        if (way != null) {
            constant = way.x() * nx + way.y() * ny + way.z() * nz;
            // e . (o x d) = o . (d x e)
            double unit = -2 * spread;
            nx = (way.y() * ez - way.z() * ey) * unit;
            ny = (way.z() * ex - way.x() * ez) * unit;
            nz = (way.x() * ey - way.y() * ex) * unit;
        }
        mx = -2 * spread * ex;
        my = -2 * spread * ey;
        mz = -2 * spread * ez;
    }

    /**
     * Computes by line how far it passes two edges of a triangle on different sides, in {@link #clearance}.
     *
     * @param edges |x| + |y| + |z| of an edge at most
     * @return lines are clear of the triangle that have more than this
     */
    public float measure(Vector a, Vector b, Vector c, double edges, int from, int to) {
        double l1Norm = distance(a, edges), scale = 1 / (edges * l1Norm);
        float[] ab = side[0], bc = side[1], ca = side[2];
        side(a, b, scale, ab, from, to);
        side(b, c, scale, bc, from, to);
        side(c, a, scale, ca, from, to);
        run(differ, ab, bc, clearance, from, to);
        run(differ, bc, ca, bc, from, to);
        run(differ, ca, ab, ca, from, to);
        run(max, bc, bc, clearance, from, to);
        run(max, ca, ca, ca, from, to);
        run(max, ca, ca, clearance, from, to);
        return (float) (8 * bound(l1Norm));
    }

    private void side(Vector a, Vector b, double scale, float[] out, int from, int to) {
        setEdge(a, b, scale);
        run(dot, out, out, out, from, to);
        if (!areAlike()) {
            run(addMoments, out, out, out, from, to);
        }
    }

    private static void run(Loop loop, float[] a, float[] b, float[] out, int from, int to) {
        loop.run(a, b, out, from, to);
    }

    private void dot(float[] out, int from, int to) {
        float[] ux = x, uy = y, uz = z;
        float vx = (float) nx, vy = (float) ny, vz = (float) nz, c = (float) constant;
        for (int i = from; i < to; i++) {
            out[i] = ux[i] * vx + uy[i] * vy + uz[i] * vz + c;
        }
    }

    private void addMoments(float[] out, int from, int to) {
        float[] ux = momentX, uy = momentY, uz = momentZ;
        float vx = (float) mx, vy = (float) my, vz = (float) mz;
        for (int i = from; i < to; i++) {
            out[i] += ux[i] * vx + uy[i] * vy + uz[i] * vz;
        }
    }

    /** Of two numbers of different signs, the difference exceeds the sum by twice the smaller one. */
    private static void differ(float[] a, float[] b, float[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.abs(a[i] - b[i]) - Math.abs(a[i] + b[i]);
        }
    }

    /** Twice the greater one of two; by magnitudes, as HotSpot makes no vectors of maxima of floats. */
    private static void max(float[] a, float[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = a[i] + out[i] + Math.abs(a[i] - out[i]);
        }
    }
}
