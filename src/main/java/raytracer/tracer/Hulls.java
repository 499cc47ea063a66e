package raytracer.tracer;

import java.util.List;
import raytracer.scene.Mesh;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** What numbered things are within: the points that are no farther than a radius from a triangle. */
@FunctionalInterface
interface Hulls {

    /** Where a hull has its radius: after x, y and z of three corners. */
    int RADIUS = 9;

    /** Numbers of one hull. */
    int SIZE = 10;

    /** Writes the hull of thing k, in world space. */
    void of(int k, double[] hull);

    /** The corners coincide in the centre. */
    static Hulls of(List<Shape.Sphere> spheres) {
        return (k, hull) -> {
            for (int corner = 0; corner < 3; corner++) {
                set(hull, corner, spheres.get(k).centre());
            }
            hull[RADIUS] = spheres.get(k).radius();
        };
    }

    /**
     * Triangles themselves.
     *
     * @param order by a triangle's number here: its number in the mesh
     */
    static Hulls of(Mesh mesh, int[] order) {
        return (k, hull) -> {
            for (int corner = 0; corner < 3; corner++) {
                set(hull, corner, mesh.corner(order[k], corner));
            }
            hull[RADIUS] = 0;
        };
    }

    private static void set(double[] hull, int corner, Vector v) {
        hull[3 * corner] = v.x();
        hull[3 * corner + 1] = v.y();
        hull[3 * corner + 2] = v.z();
    }
}
