package raytracer.scene;

import java.util.List;

/**
 * All that a picture depends on. Whoever makes one has validated it: every number is finite and in the range that its
 * record states, so nothing behind this package checks again.
 *
 * @param width    in pixels, at least 1
 * @param height   in pixels, at least 1
 * @param maxDepth how many surfaces a path from the eye may hit, at least 1: 1 means no mirrors
 * @param lights   in the order of declaration
 * @param shapes   in the order of declaration: of surfaces at the same distance the first is seen
 * @param mesh     what the {@link Shape.Triangles} among the shapes are triangles of
 * @param output   the file name that the scene asks for
 */
public record Scene(
        int width, int height, Camera camera, int maxDepth,
        List<Light> lights, List<Shape> shapes, Mesh mesh, String output) {

    public Scene {
        lights = List.copyOf(lights);
        shapes = List.copyOf(shapes);
    }

    public Scene withSize(int newWidth, int newHeight) {
        return new Scene(newWidth, newHeight, camera, maxDepth, lights, shapes, mesh, output);
    }

    public Scene withMaxDepth(int newMaxDepth) {
        return new Scene(width, height, camera, newMaxDepth, lights, shapes, mesh, output);
    }
}
