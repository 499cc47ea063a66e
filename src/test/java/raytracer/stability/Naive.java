package raytracer.stability;

import raytracer.scene.Vector;

/** The textbook's methods, which fail: kept here so that tests can show where. A distance is NaN where nothing is met. */
public final class Naive {

    private Naive() { }

    /** The quadratic formula as in school; the nearest root above a limit. */
    public static double sphere(Vector o, Vector d, Vector centre, double radius, double epsilon) {
        Vector x = o.minus(centre);
        double a = d.dot(d), b = 2 * x.dot(d), c = x.dot(x) - radius * radius;
        double discriminant = b * b - 4 * a * c;
        if (discriminant < 0) {
            return Double.NaN;
        }
        double near = (-b - Math.sqrt(discriminant)) / (2 * a), far = (-b + Math.sqrt(discriminant)) / (2 * a);
        return near > epsilon ? near : far > epsilon ? far : Double.NaN;
    }

    /** Moeller and Trumbore's triangle, with the customary limit on the determinant. */
    public static double triangle(Vector o, Vector d, Vector a, Vector b, Vector c, double epsilon) {
        Vector e1 = b.minus(a), e2 = c.minus(a), p = d.cross(e2);
        double determinant = e1.dot(p);
        if (Math.abs(determinant) <= epsilon) {
            return Double.NaN;
        }
        Vector s = o.minus(a);
        double u = s.dot(p) / determinant;
        if (u < 0 || u > 1) {
            return Double.NaN;
        }
        Vector q = s.cross(e1);
        double v = d.dot(q) / determinant;
        if (v < 0 || u + v > 1) {
            return Double.NaN;
        }
        double t = e2.dot(q) / determinant;
        return t > epsilon ? t : Double.NaN;
    }

    /** A plane that is parallel below a fixed limit. */
    public static double plane(Vector o, Vector d, Vector point, Vector normal, double epsilon) {
        double cosine = d.dot(normal);
        if (Math.abs(cosine) < epsilon) {
            return Double.NaN;
        }
        double t = point.minus(o).dot(normal) / cosine;
        return t > epsilon ? t : Double.NaN;
    }

    /** Slabs with reciprocals and the library's min and max, which pass NaN on. */
    public static boolean box(Vector o, Vector d, double[] box) {
        double[] os = {o.x(), o.y(), o.z()}, ds = {d.x(), d.y(), d.z()};
        double near = 0, far = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double reciprocal = 1 / ds[axis];
            double t0 = (box[axis] - os[axis]) * reciprocal, t1 = (box[axis + 3] - os[axis]) * reciprocal;
            near = Math.max(near, Math.min(t0, t1));
            far = Math.min(far, Math.max(t0, t1));
        }
        return near <= far;
    }

    public static Vector point(Vector o, Vector d, double t) {
        return new Vector(o.x() + t * d.x(), o.y() + t * d.y(), o.z() + t * d.z());
    }

    public static Vector reflect(Vector d, Vector n) {
        double twice = 2 * d.dot(n);
        return new Vector(d.x() - twice * n.x(), d.y() - twice * n.y(), d.z() - twice * n.z());
    }
}
