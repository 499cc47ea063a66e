package raytracer.scene;

/** A surface, or a run of surfaces that were declared one after the other and are made of one material. */
public sealed interface Shape {

    Material material();

    /** How many surfaces this stands for: they take as many numbers in the order of declaration. */
    default int count() {
        return 1;
    }

    /**
     * A sphere; its normal points away from the centre, inside and outside.
     *
     * @param radius more than 0
     */
    record Sphere(Vector centre, double radius, Material material) implements Shape { }

    /**
     * An infinite plane.
     *
     * @param point  any point of the plane
     * @param normal any length but 0
     */
    record Plane(Vector point, Vector normal, Material material) implements Shape { }

    /**
     * Triangles {@code first} to {@code first + count - 1} of the scene's mesh; runs follow one another in the mesh as
     * among the shapes, and leave none out. A run, not an object per triangle: a mesh may hold millions.
     */
    public record Triangles(int first, int count, Material material) implements Shape { }
}
