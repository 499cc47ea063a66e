package raytracer.tracer.arithmetic;

import raytracer.scene.Vector;

/**
 * As many vectors as a batch has rays, and arithmetic on them, from one index up to before another. The loops are so small
 * that HotSpot's C2 makes vector instructions of them: it packs what it has unrolled, and unrolls a loop to 60 of its nodes
 * at most (-XX:LoopUnrollLimit).
 */
public record Vectors(double[] x, double[] y, double[] z) {

    public Vectors() {
        this(new double[Batch.CAPACITY], new double[Batch.CAPACITY], new double[Batch.CAPACITY]);
    }

    /** Vector i as an object. */
    public Vector get(int i) {
        return new Vector(x[i], y[i], z[i]);
    }

    /** out = a . v, where a is the same for all. */
    public void dot(double ax, double ay, double az, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ax * x[i] + ay * y[i] + az * z[i];
        }
    }

    /** out += a . v, where a is the same for all. */
    public void addDot(double ax, double ay, double az, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] += ax * x[i] + ay * y[i] + az * z[i];
        }
    }

    /**
     * Divides vectors by their lengths, by way of the reciprocal, whose rounding changes the length alone and not the
     * direction. The zero vector stays what it is.
     *
     * @param length the lengths before that
     */
    public void normalise(double[] length, int from, int to) {
        for (int i = from; i < to; i++) {
            length[i] = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        }
        for (int i = from; i < to; i++) {
            double reciprocal = 1 / Math.max(length[i], Double.MIN_NORMAL);
            x[i] *= reciprocal;
            y[i] *= reciprocal;
            z[i] *= reciprocal;
        }
    }

    /** out = a x b */
    public static void cross(Vectors a, Vectors b, Vectors out, int from, int to) {
        cross(a.y, a.z, b.y, b.z, out.x, from, to);
        cross(a.z, a.x, b.z, b.x, out.y, from, to);
        cross(a.x, a.y, b.x, b.y, out.z, from, to);
    }

    /** One component of a cross product, of the other two: out = ay bz - az by. */
    private static void cross(double[] ay, double[] az, double[] by, double[] bz, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ay[i] * bz[i] - az[i] * by[i];
        }
    }
}
