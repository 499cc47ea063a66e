package raytracer.exact;

import raytracer.scene.Vector;

/** Single meetings of a ray of doubles in 104 bits, for tests of kernels. A distance is NaN where nothing is met. */
public final class ExactKernels {

    private ExactKernels() { }

    /** The nearest root above 0; a direction of any length near 1 is taken as it is. */
    public static double sphere(Vector o, Vector d, Vector centre, double radius) {
        ExactVector x = ExactVector.of(o).minus(ExactVector.of(centre)), w = ExactVector.of(d);
        Exact a = w.dot(w), b = x.dot(w), c = x.dot(x).minus(Exact.of(radius).times(radius));
        Exact discriminant = b.times(b).minus(a.times(c));
        if (discriminant.sign() < 0) {
            return Double.NaN;
        }
        Exact root = discriminant.root();
        Exact near = b.negated().minus(root).over(a), far = b.negated().plus(root).over(a);
        return near.sign() > 0 ? near.high() : far.sign() > 0 ? far.high() : Double.NaN;
    }

    /** How far the ray passes from the centre, less the radius, over the radius. */
    public static double clearance(Vector o, Vector d, Vector centre, double radius) {
        ExactVector x = ExactVector.of(centre).minus(ExactVector.of(o)), w = ExactVector.of(d);
        return x.cross(w).length().over(w.length()).minus(Exact.of(radius)).high() / radius;
    }

    public static double plane(Vector o, Vector d, Vector point, Vector normal) {
        ExactVector n = ExactVector.of(normal);
        Exact cosine = ExactVector.of(d).dot(n);
        Exact t = ExactVector.of(point).minus(ExactVector.of(o)).dot(n).over(cosine);
        return cosine.sign() != 0 && t.sign() > 0 ? t.high() : Double.NaN;
    }

    /** On an edge counts as met. */
    public static double triangle(Vector o, Vector d, Vector a, Vector b, Vector c) {
        ExactVector p = ExactVector.of(o), w = ExactVector.of(d);
        ExactVector x = ExactVector.of(a).minus(p), y = ExactVector.of(b).minus(p), z = ExactVector.of(c).minus(p);
        int ab = w.dot(x.cross(y)).sign(), bc = w.dot(y.cross(z)).sign(), ca = w.dot(z.cross(x)).sign();
        if (!(ab >= 0 && bc >= 0 && ca >= 0 || ab <= 0 && bc <= 0 && ca <= 0)) {
            return Double.NaN;
        }
        ExactVector n = y.minus(x).cross(z.minus(x));
        Exact cosine = w.dot(n);
        if (cosine.sign() == 0) {
            return Double.NaN;
        }
        double t = x.dot(n).over(cosine).high();
        return t > 0 ? t : Double.NaN;
    }
}
