package raytracer.tracer;

/**
 * Arithmetic on whole arrays, from one index up to before another. Each pass is so small that HotSpot's C2 turns it
 * into vector instructions: it gives up on loops of more than about seven arrays, and on any that compares.
 */
final class Passes {

    private Passes() { }

    /** out = a . b */
    static void dot(double[] ax, double[] ay, double[] az, double[] bx, double[] by, double[] bz, double[] out,
            int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i];
        }
    }

    /** out = a . x + b . y, with a and b the same for all */
    static void dots(double ax, double ay, double az, double[] x1, double[] y1, double[] z1,
            double bx, double by, double bz, double[] x2, double[] y2, double[] z2, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ax * x1[i] + ay * y1[i] + az * z1[i] + (bx * x2[i] + by * y2[i] + bz * z2[i]);
        }
    }

    /** out = min(a b, b c, c a) */
    static void leastProduct(double[] a, double[] b, double[] c, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.min(a[i] * b[i], Math.min(b[i] * c[i], c[i] * a[i]));
        }
    }

    /** One component of a x b, of the other two: out = ay bz - az by. */
    static void cross(double[] ay, double[] az, double[] by, double[] bz, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ay[i] * bz[i] - az[i] * by[i];
        }
    }

    /** out = a - b */
    static void subtract(double[] a, double[] b, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = a[i] - b[i];
        }
    }

    /** out = a - b, the same a for all */
    static void subtract(double a, double[] b, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = a - b[i];
        }
    }

    /** a += t b */
    static void addProduct(double[] a, double[] t, double[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] += t[i] * b[i];
        }
    }

    /** a -= 2 t b */
    static void subtractTwice(double[] a, double[] t, double[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] -= 2 * t[i] * b[i];
        }
    }

    /** out = |(x, y, z)| */
    static void length(double[] x, double[] y, double[] z, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        }
    }

    /** out = |x| + |y| + |z| */
    static void reach(double[] x, double[] y, double[] z, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Math.abs(x[i]) + Math.abs(y[i]) + Math.abs(z[i]);
        }
    }

    /**
     * (x, y, z) /= length, by way of the reciprocal, whose rounding changes the length alone and not the direction. The
     * zero vector stays what it is.
     */
    static void divide(double[] x, double[] y, double[] z, double[] length, int from, int to) {
        for (int i = from; i < to; i++) {
            double reciprocal = 1 / Math.max(length[i], Double.MIN_NORMAL);
            x[i] *= reciprocal;
            y[i] *= reciprocal;
            z[i] *= reciprocal;
        }
    }

    /** a /= b, which is not negative; nothing by nothing is nothing */
    static void divide(double[] a, double[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] /= Math.max(b[i], Double.MIN_NORMAL);
        }
    }

    /** a *= b */
    static void multiply(double[] a, double[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] *= b[i];
        }
    }

    /** Cuts to [0, 1]. */
    static void cut(double[] a, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] = Math.min(1, Math.max(0, a[i]));
        }
    }

    /** a = min(a, b) */
    static void limit(double[] a, double[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] = Math.min(a[i], b[i]);
        }
    }

    /** a = 1 / a */
    static void invert(double[] a, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] = 1 / a[i];
        }
    }

    /** a += f (g b) */
    static void addScaled(double[] a, double f, double g, double[] b, int from, int to) {
        for (int i = from; i < to; i++) {
            a[i] += f * (g * b[i]);
        }
    }
}
