package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bounds;

/**
 * Spheres in one array: a sphere's centre and radius are {@link #STRIDE} numbers in a row, which a cache line holds.
 */
record SphereArray(double[] numbers) {

    static final int STRIDE = 4;

    static SphereArray of(List<Shape.Sphere> spheres) {
        double[] numbers = new double[STRIDE * spheres.size()];
        for (int k = 0; k < spheres.size(); k++) {
            Vector c = spheres.get(k).centre();
            numbers[STRIDE * k] = c.x();
            numbers[STRIDE * k + 1] = c.y();
            numbers[STRIDE * k + 2] = c.z();
            numbers[STRIDE * k + 3] = spheres.get(k).radius();
        }
        return new SphereArray(numbers);
    }

    double x(int k) {
        return numbers[STRIDE * k];
    }

    double y(int k) {
        return numbers[STRIDE * k + 1];
    }

    double z(int k) {
        return numbers[STRIDE * k + 2];
    }

    double radius(int k) {
        return numbers[STRIDE * k + 3];
    }

    static Bounds bounds(List<Shape.Sphere> spheres) {
        return new Bounds() {
            @Override
            public void of(int k, double[] box) {
                Vector c = spheres.get(k).centre();
                double r = spheres.get(k).radius();
                box[0] = c.x() - r;
                box[1] = c.y() - r;
                box[2] = c.z() - r;
                box[3] = c.x() + r;
                box[4] = c.y() + r;
                box[5] = c.z() + r;
            }

            @Override
            public boolean areSame(int k, int other) {
                Vector a = spheres.get(k).centre(), b = spheres.get(other).centre();
                return a.x() == b.x() && a.y() == b.y() && a.z() == b.z()
                        && spheres.get(k).radius() == spheres.get(other).radius();
            }
        };
    }
}
