package raytracer.tracer.surface;

import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.rays.Rays;

/** What one thread needs to intersect its {@link Rays} with surfaces: a walk, and by ray numbers in between. */
public final class Workspace {

    public final BvhWalk walk = new BvhWalk();
    public final SieveLine line = new SieveLine();

    public final LineBundle lines = new LineBundle();

    // By ray, of a sphere: direction . (origin - centre); the square of the perpendicular from the centre; distances, and
    // other numbers of hits.
    public final double[] along = new double[Batch.CAPACITY];
    public final double[] square = new double[Batch.CAPACITY];
    public final double[] l1Norm = new double[Batch.CAPACITY];
    public final double[] half = new double[Batch.CAPACITY];
    public final double[] part = new double[Batch.CAPACITY];
}
