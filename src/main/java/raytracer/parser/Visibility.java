package raytracer.parser;

import java.util.List;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** Finds out beforehand that a picture will be black, which is hardly what its author wants. */
final class Visibility {

    private Visibility() { }

    /** Why nothing can be seen; null if something may be. */
    static String darkness(Scene scene) {
        if (scene.lights().isEmpty() && !anyHasAmbientColour(scene.shapes())) {
            return "there is no light and no ambient colour";
        }
        return anyIsInFront(scene) ? null : "nothing is in front of the camera";
    }

    private static boolean anyHasAmbientColour(List<Shape> shapes) {
        for (Shape shape : shapes) {
            if (!shape.material().ambient().isBlack()) {
                return true;
            }
        }
        return false;
    }

    private static boolean anyIsInFront(Scene scene) {
        Vector eye = scene.camera().eye();
        Vector forward = scene.camera().at().minus(eye).unit();
        for (Shape shape : scene.shapes()) {
            if (isInFront(shape, eye, forward, scene.mesh())) {
                return true;
            }
        }
        return false;
    }

    private static boolean isInFront(Shape shape, Vector eye, Vector forward, Mesh mesh) {
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
