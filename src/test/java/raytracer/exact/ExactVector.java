package raytracer.exact;

import raytracer.scene.Vector;

/** A vector of {@link Exact} numbers. */
record ExactVector(Exact x, Exact y, Exact z) {

    static ExactVector of(Vector v) {
        return new ExactVector(Exact.of(v.x()), Exact.of(v.y()), Exact.of(v.z()));
    }

    ExactVector plus(ExactVector o) {
        return new ExactVector(x.plus(o.x), y.plus(o.y), z.plus(o.z));
    }

    ExactVector minus(ExactVector o) {
        return new ExactVector(x.minus(o.x), y.minus(o.y), z.minus(o.z));
    }

    ExactVector times(Exact f) {
        return new ExactVector(x.times(f), y.times(f), z.times(f));
    }

    Exact dot(ExactVector o) {
        return x.times(o.x).plus(y.times(o.y)).plus(z.times(o.z));
    }

    ExactVector cross(ExactVector o) {
        return new ExactVector(y.times(o.z).minus(z.times(o.y)), z.times(o.x).minus(x.times(o.z)),
                x.times(o.y).minus(y.times(o.x)));
    }

    Exact length() {
        return dot(this).root();
    }

    ExactVector unit() {
        return times(Exact.ONE.over(length()));
    }

    /** |x| + |y| + |z|, as a double. */
    double size() {
        return Math.abs(x.high()) + Math.abs(y.high()) + Math.abs(z.high());
    }

    double[] high() {
        return new double[] {x.high(), y.high(), z.high()};
    }

    Vector rounded() {
        return new Vector(x.high(), y.high(), z.high());
    }
}
