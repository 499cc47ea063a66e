package raytracer.tracer.primitive;

import raytracer.scene.Mesh;
import raytracer.tracer.bvh.Bounds;

/** The boxes of a mesh's triangles. */
public record TriangleBounds(Mesh mesh) implements Bounds {

    @Override
    public void of(int k, double[] box) {
        for (int axis = 0; axis < 3; axis++) {
            double a = mesh.coordinate(k, 0, axis), b = mesh.coordinate(k, 1, axis), c = mesh.coordinate(k, 2, axis);
            box[axis] = Math.min(a, Math.min(b, c));
            box[axis + 3] = Math.max(a, Math.max(b, c));
        }
    }

    @Override
    public boolean areSame(int k, int other) {
        for (int number = 0; number < 9; number++) {
            if (mesh.coordinate(k, number / 3, number % 3) != mesh.coordinate(other, number / 3, number % 3)) {
                return false;
            }
        }
        return true;
    }
}
