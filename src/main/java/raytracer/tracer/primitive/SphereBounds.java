package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bounds;

/** The boxes of spheres, rounded outwards: far from the origin, a box could else leave out a part of its sphere. */
public record SphereBounds(List<Shape.Sphere> spheres) implements Bounds {

    @Override
    public void of(int k, double[] box) {
        Vector c = spheres.get(k).centre();
        double r = spheres.get(k).radius();
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = Math.nextDown(c.coordinate(axis) - r);
            box[axis + 3] = Math.nextUp(c.coordinate(axis) + r);
        }
    }

    @Override
    public boolean areSame(int k, int other) {
        Vector a = spheres.get(k).centre(), b = spheres.get(other).centre();
        return a.x() == b.x() && a.y() == b.y() && a.z() == b.z()
                && spheres.get(k).radius() == spheres.get(other).radius();
    }
}
