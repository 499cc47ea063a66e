package raytracer.tracer;

/** As many vectors as a tile has rays. */
record Vectors(double[] x, double[] y, double[] z) {

    Vectors() {
        this(new double[Rays.CAPACITY], new double[Rays.CAPACITY], new double[Rays.CAPACITY]);
    }
}
