package raytracer.text;

import java.util.Optional;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** Finds out beforehand that a picture will be black, which is hardly what its author wants. */
final class Visibility {

    private Visibility() { }

    /** Why nothing can be seen; empty if something may be. */
    static Optional<String> darkness(Scene scene) {
        if (scene.lights().isEmpty() && scene.shapes().stream().allMatch(s -> s.material().ambient().isBlack())) {
            return Optional.of("there is no light and no ambient colour");
        }
        Vector forward = scene.camera().at().minus(scene.camera().eye()).unit();
        if (scene.shapes().stream().noneMatch(s -> inFront(s, scene.camera().eye(), forward, scene.mesh()))) {
            return Optional.of("nothing is in front of the camera");
        }
        return Optional.empty();
    }

    private static boolean inFront(Shape shape, Vector eye, Vector forward, Mesh mesh) {
        if (shape instanceof Shape.Sphere sphere) {
            return sphere.centre().minus(eye).dot(forward) + sphere.radius() > 0;
        }
        if (shape instanceof Shape.Plane plane) {
            Vector slope = plane.normal().unit().cross(forward);
            boolean facing = slope.isZero();
            return !facing || plane.point().minus(eye).dot(forward) > 0;
        }
        Shape.Triangles run = (Shape.Triangles) shape;
        for (int triangle = run.first(); triangle < run.first() + run.count(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                if (mesh.corner(triangle, corner).minus(eye).dot(forward) > 0) {
                    return true;
                }
            }
        }
        return false;
    }
}
