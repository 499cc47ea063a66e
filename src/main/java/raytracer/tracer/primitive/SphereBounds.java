package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bounds;

/** The boxes of spheres. */
public record SphereBounds(List<Shape.Sphere> spheres) implements Bounds {

    @Override
    public void of(int k, double[] box) {
        Vector c = spheres.get(k).centre();
        double r = spheres.get(k).radius();
        box[0] = c.x() - r;
        box[1] = c.y() - r;
        box[2] = c.z() - r;
        box[3] = c.x() + r;
        box[4] = c.y() + r;
        box[5] = c.z() + r;
    }

    @Override
    public boolean areSame(int k, int other) {
        Vector a = spheres.get(k).centre(), b = spheres.get(other).centre();
        return a.x() == b.x() && a.y() == b.y() && a.z() == b.z()
                && spheres.get(k).radius() == spheres.get(other).radius();
    }
}
