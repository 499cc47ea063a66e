package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** All spheres. */
public final class Spheres extends Surfaces {

    /** Of the tree: a ray tries a box much faster than a sphere. */
    public static final int LEAF_SIZE = 1;

    private final Sphere[] spheres;
    private final SphereHits[] hits;

    /** @param inOrder in the order of the tree's leaves */
    public Spheres(List<Shape.Sphere> inOrder, int firstSurface, Bvh bvh) {
        super("spheres", firstSurface, bvh);
        spheres = new Sphere[inOrder.size()];
        hits = inOrder.stream().map(SphereHits::new).toArray(SphereHits[]::new);
        for (int k = 0; k < spheres.length; k++) {
            spheres[k] = new Sphere(inOrder.get(k), surface(k), bvh.room());
        }
    }

    @Override
    protected double distance(Rays rays, int i, int k) {
        return spheres[k].distance(rays, i);
    }

    @Override
    protected double distanceError(Rays rays, int i, int k, double t) {
        return spheres[k].distanceError(rays, i, t);
    }

    @Override
    public void intersectAll(Rays rays, int from, int to, int k, Workspace workspace) {
        spheres[k].intersectAll(rays, from, to, workspace);
    }

    @Override
    public boolean blocks(Rays rays, ShadowRays shadows, int i, int k) {
        return spheres[k].blocks(rays, shadows, i, spheres[k].sideOf(shadows.light));
    }

    @Override
    public void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Workspace workspace) {
        spheres[k].blockAll(rays, shadows, from, to, workspace);
    }

    @Override
    public void moveToHits(Rays rays, int from, int to, Workspace workspace) {
        // Those of a run have hit the same sphere.
        for (int start = from, end; start < to; start = end) {
            end = start + 1;
            while (end < to && rays.hit[end] == rays.hit[start]) {
                end++;
            }
            hits[number(rays.hit[start])].moveToHits(rays, start, end, workspace);
        }
    }
}
