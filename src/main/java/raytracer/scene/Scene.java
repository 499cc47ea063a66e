package raytracer.scene;

import java.util.List;

/**
 * All that a picture depends on. Whoever makes one has validated it: every number is finite and in the range that its
 * record states, so nothing behind this package checks again.
 *
 * @param width    in pixels, at least 1
 * @param height   in pixels, at least 1
 * @param maxDepth how many surfaces a path from the eye may hit, at least 1: 1 means no mirrors
 * @param shadow   whether surfaces block light
 * @param lights   in the order of declaration
 * @param shapes   in the order of declaration: of surfaces at the same distance the first is seen
 * @param mesh     what the {@link Shape.Triangles} among the shapes are triangles of
 * @param output   the file name that the scene asks for
 */
public record Scene(
        int width, int height, Camera camera, int maxDepth, boolean shadow,
        List<Light> lights, List<Shape> shapes, Mesh mesh, String output) {

    public Scene {
        lights = List.copyOf(lights);
        shapes = List.copyOf(shapes);
    }

    /** The shape that a surface is of, by its number in the order of declaration. */
    public Shape shape(int surface) {
        int end = 0;
        for (Shape shape : shapes) {
            end += shape.count();
            if (surface < end) {
                return shape;
            }
        }
        throw new IllegalArgumentException("there is no surface " + surface);
    }

    public Scene withSize(int newWidth, int newHeight) {
        return new Scene(newWidth, newHeight, camera, maxDepth, shadow, lights, shapes, mesh, output);
    }

    public Scene withCamera(Camera newCamera) {
        return new Scene(width, height, newCamera, maxDepth, shadow, lights, shapes, mesh, output);
    }

    /** The same scene, of which all triangles show their other sides. */
    public Scene withMeshTurned() {
        return new Scene(width, height, camera, maxDepth, shadow, lights, shapes, mesh.turned(), output);
    }

    public Scene withMaxDepth(int newMaxDepth) {
        return new Scene(width, height, camera, newMaxDepth, shadow, lights, shapes, mesh, output);
    }
}
