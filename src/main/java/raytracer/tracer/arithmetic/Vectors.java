package raytracer.tracer.arithmetic;

import raytracer.scene.Vector;

/**
 * As many vectors as a batch has rays, and arithmetic on them and on arrays, from one index up to before another. The loops are
 * so small that HotSpot's C2 makes vector instructions of them: it packs what it has unrolled, and unrolls a loop to 60 of its
 * nodes at most (-XX:LoopUnrollLimit). Each is a method of its own: of one with several, C2 compiles all anew for each that
 * gets hot, which takes up to 70 ms, while the program waits.
 */
public record Vectors(double[] x, double[] y, double[] z) {

    public Vectors() {
        this(new double[Batch.CAPACITY], new double[Batch.CAPACITY], new double[Batch.CAPACITY]);
    }

    /** Vector i as an object. */
    public Vector get(int i) {
        return new Vector(x[i], y[i], z[i]);
    }

    /** out = a . b */
    public void dot(Vectors other, double[] out, int from, int to) {
        double[] ax = x, ay = y, az = z, bx = other.x, by = other.y, bz = other.z;
        for (int i = from; i < to; i++) {
            out[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i];
        }
    }

    /** out = a . (b - v), where v is the same for all */
    public void dotDifference(Vectors b, double vx, double vy, double vz, double[] out, int from, int to) {
        double[] bx = b.x, by = b.y, bz = b.z;
        for (int i = from; i < to; i++) {
            out[i] = (bx[i] - vx) * x[i] + (by[i] - vy) * y[i] + (bz[i] - vz) * z[i];
        }
    }

    /** Adds other vectors times numbers. */
    public void addScaled(double[] factor, Vectors other, int from, int to) {
        addProduct(factor, other.x, x, from, to);
        addProduct(factor, other.y, y, from, to);
        addProduct(factor, other.z, z, from, to);
    }

    private static void addProduct(double[] a, double[] b, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] += a[i] * b[i];
        }
    }

    /** Sets these to the differences of others and a vector that is the same for all. */
    public void setDifference(Vectors other, double vx, double vy, double vz, int from, int to) {
        setDifference(other.x, vx, x, from, to);
        setDifference(other.y, vy, y, from, to);
        setDifference(other.z, vz, z, from, to);
    }

    private static void setDifference(double[] a, double b, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = a[i] - b;
        }
    }

    /** out = |x| + |y| + |z| of these, seen from a point. */
    public void l1Norm(double vx, double vy, double vz, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.abs(x[i] - vx) + Math.abs(y[i] - vy) + Math.abs(z[i] - vz);
        }
    }

    /** out *= a */
    public static void multiply(double[] a, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] *= a[i];
        }
    }

    /**
     * Divides vectors by their lengths, by way of the reciprocal, whose rounding changes the length alone and not the
     * direction. The zero vector stays what it is.
     *
     * @param length the lengths before that
     */
    public void normalise(double[] length, int from, int to) {
        lengths(length, from, to);
        divide(length, from, to);
    }

    private void lengths(double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        }
    }

    private void divide(double[] length, int from, int to) {
        for (int i = from; i < to; i++) {
            double reciprocal = 1 / Math.max(length[i], Double.MIN_NORMAL);
            x[i] *= reciprocal;
            y[i] *= reciprocal;
            z[i] *= reciprocal;
        }
    }
}
