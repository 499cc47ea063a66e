package raytracer.tracer;

/** As many vectors as a tile has rays. */
record Vectors(double[] x, double[] y, double[] z) {

    Vectors() {
        this(new double[Rays.CAPACITY], new double[Rays.CAPACITY], new double[Rays.CAPACITY]);
    }

    /** One component of a x b, of the other two: out = ay bz - az by. */
    static void cross(double[] ay, double[] az, double[] by, double[] bz, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ay[i] * bz[i] - az[i] * by[i];
        }
    }

    /**
     * Brings one component of points from world space to a tree's: out = (world - centre) scale - eye.
     *
     * @param eye from where the points are seen, in the tree's space
     */
    static void toTreeSpace(double[] world, double centre, double scale, double eye, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = (world[i] - centre) * scale - eye;
        }
    }

    /** out = a . v, with a the same for all */
    static void dot(double ax, double ay, double az, double[] x, double[] y, double[] z,
            double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = ax * x[i] + ay * y[i] + az * z[i];
        }
    }

    /** out += a . v */
    static void addDot(double ax, double ay, double az, double[] x, double[] y, double[] z,
            double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] += ax * x[i] + ay * y[i] + az * z[i];
        }
    }
}
