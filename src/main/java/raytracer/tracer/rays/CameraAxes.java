package raytracer.tracer.rays;

import raytracer.scene.Camera;
import raytracer.scene.Vector;

/**
 * The camera's axes, of which directions from the eye are sums. A coordinate of a direction rounds in proportion to the
 * terms it is the sum of, and these may be small where others are not: a ray that grazes a floor at 1e-15 goes down by
 * 1e-15 and some units in the last place of that, not of 1.
 *
 * @param rightTerms by coordinate, the magnitudes that it is a difference of; those of {@code backward} are its own
 */
public record CameraAxes(Vector right, Vector up, Vector backward, Vector rightTerms, Vector upTerms) {

    public static CameraAxes of(Camera camera) {
        Vector right = camera.right(), backward = camera.backward();
        double sine = camera.up().unit().cross(backward).length();
        Vector rightTerms = crossTerms(camera.up().unit(), backward).times(1 / sine);
        return new CameraAxes(right, backward.cross(right), backward, rightTerms, crossTerms(backward, rightTerms));
    }

    /** By coordinate of a x b, the sum of its two products' magnitudes. */
    private static Vector crossTerms(Vector a, Vector b) {
        return new Vector(Math.abs(a.y() * b.z()) + Math.abs(a.z() * b.y()), Math.abs(a.z() * b.x()) + Math.abs(a.x() * b.z()),
                Math.abs(a.x() * b.y()) + Math.abs(a.y() * b.x()));
    }

    /** By coordinate of a unit direction from the eye, the magnitudes that it is the sum of. */
    Vector terms(Vector direction) {
        double r = Math.abs(direction.dot(right)), u = Math.abs(direction.dot(up)), b = Math.abs(direction.dot(backward));
        return new Vector(r * rightTerms.x() + u * upTerms.x() + b * Math.abs(backward.x()),
                r * rightTerms.y() + u * upTerms.y() + b * Math.abs(backward.y()),
                r * rightTerms.z() + u * upTerms.z() + b * Math.abs(backward.z()));
    }
}
