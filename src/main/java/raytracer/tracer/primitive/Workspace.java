package raytracer.tracer.primitive;

import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.Rays;

/** What one thread needs to intersect its {@link Rays} with surfaces: a walk, and by ray numbers in between. */
public final class Workspace {

    public final BvhWalk walk = new BvhWalk();
    final TriangleSieve.Line line = new TriangleSieve.Line();

    /** Made when the first ray hits a sphere. */
    SphereHits sphereHits;

    /** Rays that a pass over all of them could not decide. */
    final int[] doubtful = new int[Batch.CAPACITY];
    int doubtfulCount;

    final double[] along = new double[Batch.CAPACITY];
    final double[] square = new double[Batch.CAPACITY];
    final double[] l1Norm = new double[Batch.CAPACITY];
    final double[] distance = new double[Batch.CAPACITY];
    final double[] centreX = new double[Batch.CAPACITY];
    final double[] centreY = new double[Batch.CAPACITY];
    final double[] centreZ = new double[Batch.CAPACITY];
    final double[] radius = new double[Batch.CAPACITY];

    // Origin x direction, the moments of rays' lines; and bounds on the rays' errors and distances from the origin.
    final Vectors moment = new Vectors();
    double originError;
    double directionError;
    double farthest;
}
