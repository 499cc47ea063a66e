package raytracer.tracer.lightbuffer;

import raytracer.scene.Vector;

/** What numbered primitives are within: the points that are no farther than a radius from a triangle. */
public interface BoundingShapes {

    /** In world space; for something round all three are its centre. */
    Vector corner(int k, int corner);

    double radius(int k);
}
