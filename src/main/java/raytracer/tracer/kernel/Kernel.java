package raytracer.tracer.kernel;

import java.util.Arrays;

/**
 * Arithmetic on all of a tile's numbers or vectors, from one index up to before another. Each of its loops is so small
 * that HotSpot's C2 turns it into vector instructions. It gives up on comparisons; and it packs into one instruction
 * what it has unrolled, but unrolls a loop to 60 of its nodes at most, so that a loop of a dozen operations, or of
 * fewer on many arrays, may stay as it is, without a word: with -XX:LoopUnrollLimit=200 it would then be faster.
 *
 * <p>Kernels are objects that know their arrays, and are run by way of {@link #run(Kernel, int, int)}, so that each
 * kind is compiled once. Were they methods, C2 would copy them into every method on the way there, some several times
 * over, and be busy for seconds.
 */
public interface Kernel {

    void run(int from, int to);

    /** Runs a kernel of a kind that HotSpot does not know, even in a method that has just made it. */
    static void run(Kernel kernel, int from, int to) {
        unknown(kernel, 2).run(from, to);
    }

    /**
     * HotSpot inlines recursion one level deep (-XX:MaxRecursiveInlineLevel), so two levels hide the receiver's type.
     */
    private static Kernel unknown(Kernel kernel, int deeper) {
        return deeper > 0 ? unknown(kernel, deeper - 1) : kernel;
    }

    /** One kernel after the other. */
    record InTurn(Kernel... kernels) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (Kernel kernel : kernels) {
                // Not by way of run: here HotSpot has seen kernels of any kind.
                kernel.run(from, to);
            }
        }
    }

    /** a = value */
    record Fill(double[] a, double value) implements Kernel {
        @Override
        public void run(int from, int to) {
            Arrays.fill(a, from, to, value);
        }
    }

    /** out = a - b */
    static Kernel subtract(Vectors a, Vectors b, Vectors out) {
        return new InTurn(new Subtract(a.x(), b.x(), out.x()), new Subtract(a.y(), b.y(), out.y()),
                new Subtract(a.z(), b.z(), out.z()));
    }

    /** out = a - b */
    record Subtract(double[] a, double[] b, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = a[i] - b[i];
            }
        }
    }

    /** out = a + b */
    record Add(double[] a, double[] b, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = a[i] + b[i];
            }
        }
    }

    /** out = a + factor t b */
    static Kernel addProduct(Vectors a, double factor, double[] t, Vectors b, Vectors out) {
        return new InTurn(new AddProduct(a.x(), factor, t, b.x(), out.x()),
                new AddProduct(a.y(), factor, t, b.y(), out.y()), new AddProduct(a.z(), factor, t, b.z(), out.z()));
    }

    /** out = a + factor t b */
    record AddProduct(double[] a, double factor, double[] t, double[] b, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = a[i] + factor * t[i] * b[i];
            }
        }
    }

    /** out = a . b */
    record Dot(Vectors a, Vectors b, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] ax = a.x(), ay = a.y(), az = a.z(), bx = b.x(), by = b.y(), bz = b.z();
            for (int i = from; i < to; i++) {
                out[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i];
            }
        }
    }

    /** out = a . v, where a is the same for all. */
    record DotWith(double ax, double ay, double az, Vectors v, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] x = v.x(), y = v.y(), z = v.z();
            for (int i = from; i < to; i++) {
                out[i] = ax * x[i] + ay * y[i] + az * z[i];
            }
        }
    }

    /** out += a . v, where a is the same for all. */
    record AddDotWith(double ax, double ay, double az, Vectors v, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] x = v.x(), y = v.y(), z = v.z();
            for (int i = from; i < to; i++) {
                out[i] += ax * x[i] + ay * y[i] + az * z[i];
            }
        }
    }

    /** out = |v|, as the root of squares. */
    record Length(Vectors v, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] x = v.x(), y = v.y(), z = v.z();
            for (int i = from; i < to; i++) {
                out[i] = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
            }
        }
    }

    /** out = |x| + |y| + |z| */
    record L1Norm(Vectors v, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] x = v.x(), y = v.y(), z = v.z();
            for (int i = from; i < to; i++) {
                out[i] = Math.abs(x[i]) + Math.abs(y[i]) + Math.abs(z[i]);
            }
        }
    }

    /**
     * v /= length, by way of the reciprocal, whose rounding changes the length alone and not the direction. The zero
     * vector stays what it is.
     */
    record DivideByLength(Vectors v, double[] length) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] x = v.x(), y = v.y(), z = v.z();
            for (int i = from; i < to; i++) {
                double reciprocal = 1 / Math.max(length[i], Double.MIN_NORMAL);
                x[i] *= reciprocal;
                y[i] *= reciprocal;
                z[i] *= reciprocal;
            }
        }
    }

    /** a = factor a + term */
    record Linear(double[] a, double factor, double term) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                a[i] = factor * a[i] + term;
            }
        }
    }
}
