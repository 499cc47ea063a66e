package raytracer.tracer.kernel;

import raytracer.scene.Vector;

/** As many vectors as a tile has rays. */
public record Vectors(double[] x, double[] y, double[] z) {

    public Vectors() {
        this(new double[Batch.CAPACITY], new double[Batch.CAPACITY], new double[Batch.CAPACITY]);
    }

    /** Vector i as an object. */
    public Vector get(int i) {
        return new Vector(x[i], y[i], z[i]);
    }

    /** Sets vector i to vector j of others. */
    public void set(int i, Vectors others, int j) {
        x[i] = others.x[j];
        y[i] = others.y[j];
        z[i] = others.z[j];
    }

    /** out = a x b */
    public static void cross(Vectors a, Vectors b, Vectors out, int from, int to) {
        Kernel.run(new Cross(a.y, a.z, b.y, b.z, out.x), from, to);
        Kernel.run(new Cross(a.z, a.x, b.z, b.x, out.y), from, to);
        Kernel.run(new Cross(a.x, a.y, b.x, b.y, out.z), from, to);
    }

    /** One component of a cross product, of the other two: out = ay bz - az by. */
    private record Cross(double[] ay, double[] az, double[] by, double[] bz, double[] out) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = ay[i] * bz[i] - az[i] * by[i];
            }
        }
    }
}
