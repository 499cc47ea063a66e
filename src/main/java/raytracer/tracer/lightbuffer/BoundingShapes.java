package raytracer.tracer.lightbuffer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Mesh;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.kernel.Vectors;

/** What numbered primitives are within: the points that are no farther than a radius from a triangle. */
@FunctionalInterface
public interface BoundingShapes {

    /** The hulls of some primitives: corners of triangles, and radii. */
    record Chunk(Vectors a, Vectors b, Vectors c, double[] radius) {

        static final int CAPACITY = Batch.CAPACITY;

        Chunk() {
            this(new Vectors(), new Vectors(), new Vectors(), new double[CAPACITY]);
        }
    }

    /** Gets the hulls of primitives {@code from} to {@code to - 1}, as many as a chunk can hold, in world space. */
    void get(int from, int to, Chunk out);

    /** The corners coincide in the centre. */
    static BoundingShapes of(List<Shape.Sphere> spheres) {
        return (from, to, out) -> {
            for (int k = from; k < to; k++) {
                Shape.Sphere sphere = spheres.get(k);
                set(out.a, k - from, sphere.centre());
                set(out.b, k - from, sphere.centre());
                set(out.c, k - from, sphere.centre());
                out.radius[k - from] = sphere.radius();
            }
        };
    }

    /**
     * Triangles themselves.
     *
     * @param order by a triangle's number here: its number in the mesh
     */
    static BoundingShapes of(Mesh mesh, int[] order) {
        return (from, to, out) -> {
            getCorners(mesh, order, 0, from, to, out.a);
            getCorners(mesh, order, 1, from, to, out.b);
            getCorners(mesh, order, 2, from, to, out.c);
            Arrays.fill(out.radius, 0, to - from, 0);
        };
    }

    /** Nothing is done with them yet: so the processor waits for many of the mesh's places at the same time. */
    private static void getCorners(Mesh mesh, int[] order, int corner, int from, int to, Vectors out) {
        for (int k = from; k < to; k++) {
            set(out, k - from, mesh.corner(order[k], corner));
        }
    }

    private static void set(Vectors out, int i, Vector v) {
        out.x()[i] = v.x();
        out.y()[i] = v.y();
        out.z()[i] = v.z();
    }
}
