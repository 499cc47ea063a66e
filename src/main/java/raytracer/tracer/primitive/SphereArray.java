package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

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
}
