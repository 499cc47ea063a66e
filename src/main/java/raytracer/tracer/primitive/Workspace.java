package raytracer.tracer.primitive;

import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.Rays;

/** What one thread needs to intersect its {@link Rays} with surfaces: a walk, and by ray numbers in between. */
public final class Workspace {

    public final BvhWalk walk = new BvhWalk();
    public final SieveLine line = new SieveLine();

    /** Rays that a kernel over all of them could not decide. */
    final int[] doubtful = new int[Batch.CAPACITY];
    int doubtfulCount;

    // Of a plane: how far it is along its normal, how fast the ray goes that way, and the quotient.
    final double[] offset = new double[Batch.CAPACITY];
    final double[] cosine = new double[Batch.CAPACITY];
    final double[] distance = new double[Batch.CAPACITY];

    // Of a sphere: direction . (origin - centre), the square of half the chord, centre and radius.
    final double[] along = offset;
    final double[] square = cosine;
    final Vectors centre = new Vectors();
    final double[] radius = new double[Batch.CAPACITY];
    final double[] l1Norm = new double[Batch.CAPACITY];
    final double[] spare = square;

    // Of a triangle: the sides of its edges, and the least product of two of them.
    final Vectors sides = centre;
    final double[] minProduct = square;

    // Origin x direction, the moments of rays' lines; and bounds on the rays' errors and distances from the origin.
    final Vectors moment = new Vectors();
    double originError;
    double directionError;
    double farthest;
}
