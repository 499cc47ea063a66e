package raytracer.tracer;

/**
 * Arithmetic on all of a tile's numbers or vectors, from one index up to before another. Each of its loops is so small
 * that HotSpot's C2 turns it into vector instructions: it gives up on more than about seven arrays, and on comparisons.
 *
 * <p>Passes are objects that know their arrays, and are run from lists, so that each kind is compiled once. Were they
 * methods, C2 would copy them into every method on the way there, some several times over, and be busy for seconds.
 */
interface Pass {

    void run(int from, int to);

    static void run(Pass[] passes, int from, int to) {
        for (Pass pass : passes) {
            pass.run(from, to);
        }
    }

    /** out = a . b */
    record Dot(Vectors a, Vectors b, double[] out) implements Pass {
        @Override
        public void run(int from, int to) {
            dot(a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), out, from, to);
        }

        private static void dot(double[] ax, double[] ay, double[] az, double[] bx, double[] by, double[] bz,
                double[] out, int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i];
            }
        }
    }

    /** out = a - b */
    record Subtract(Vectors a, Vectors b, Vectors out) implements Pass {
        @Override
        public void run(int from, int to) {
            subtract(a.x(), b.x(), out.x(), from, to);
            subtract(a.y(), b.y(), out.y(), from, to);
            subtract(a.z(), b.z(), out.z(), from, to);
        }

        private static void subtract(double[] a, double[] b, double[] out, int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = a[i] - b[i];
            }
        }
    }

    /** out = a + factor t b */
    record AddProduct(Vectors a, double factor, double[] t, Vectors b, Vectors out) implements Pass {
        @Override
        public void run(int from, int to) {
            add(a.x(), factor, t, b.x(), out.x(), from, to);
            add(a.y(), factor, t, b.y(), out.y(), from, to);
            add(a.z(), factor, t, b.z(), out.z(), from, to);
        }

        private static void add(double[] a, double factor, double[] t, double[] b, double[] out, int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = a[i] + factor * t[i] * b[i];
            }
        }
    }

    /** out = |v|, as the root of squares. */
    record Length(Vectors v, double[] out) implements Pass {
        @Override
        public void run(int from, int to) {
            length(v.x(), v.y(), v.z(), out, from, to);
        }

        private static void length(double[] x, double[] y, double[] z, double[] out, int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
            }
        }
    }

    /** out = |x| + |y| + |z| */
    record Reach(Vectors v, double[] out) implements Pass {
        @Override
        public void run(int from, int to) {
            reach(v.x(), v.y(), v.z(), out, from, to);
        }

        private static void reach(double[] x, double[] y, double[] z, double[] out, int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = Math.abs(x[i]) + Math.abs(y[i]) + Math.abs(z[i]);
            }
        }
    }

    /**
     * v /= length, by way of the reciprocal, whose rounding changes the length alone and not the direction. The zero
     * vector stays what it is.
     */
    record DivideByLength(Vectors v, double[] length) implements Pass {
        @Override
        public void run(int from, int to) {
            divide(v.x(), v.y(), v.z(), length, from, to);
        }

        private static void divide(double[] x, double[] y, double[] z, double[] length, int from, int to) {
            for (int i = from; i < to; i++) {
                double reciprocal = 1 / Math.max(length[i], Double.MIN_NORMAL);
                x[i] *= reciprocal;
                y[i] *= reciprocal;
                z[i] *= reciprocal;
            }
        }
    }

    /** out = a / b, which is not negative; nothing by nothing is nothing. */
    record Divide(double[] a, double[] b, double[] out) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = a[i] / Math.max(b[i], Double.MIN_NORMAL);
            }
        }
    }

    /** a *= b */
    record Multiply(double[] a, double[] b) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                a[i] *= b[i];
            }
        }
    }

    /** a = 1 / a */
    record Invert(double[] a) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                a[i] = 1 / a[i];
            }
        }
    }

    /** Cuts to [0, 1]. */
    record Cut(double[] a) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                a[i] = Math.min(1, Math.max(0, a[i]));
            }
        }
    }

    /** a = min(a, most) */
    record Limit(double[] a, double[] most) implements Pass {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                a[i] = Math.min(a[i], most[i]);
            }
        }
    }
}
