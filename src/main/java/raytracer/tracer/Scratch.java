package raytracer.tracer;

/**
 * What one thread needs to find surfaces for its {@link Rays}: a walk, a beam, cells of a light
 * buffer, and by ray numbers in between.
 */
final class Scratch {

    final BvhWalk walk = new BvhWalk();
    final TriangleSieve.Line line = new TriangleSieve.Line();
    final Beam beam = new Beam();
    final LightBuffer.Cells cells = new LightBuffer.Cells();

    /** Made when the first ray meets a sphere. */
    SphereArrival sphereArrival;

    /** Rays that a pass over all of them could not decide. */
    final int[] doubtful = new int[Rays.CAPACITY];
    int doubtfulCount;

    final double[] along = new double[Rays.CAPACITY];
    final double[] square = new double[Rays.CAPACITY];
    final double[] reach = new double[Rays.CAPACITY];
    final double[] distance = new double[Rays.CAPACITY];
    final double[] centreX = new double[Rays.CAPACITY];
    final double[] centreY = new double[Rays.CAPACITY];
    final double[] centreZ = new double[Rays.CAPACITY];
    final double[] radius = new double[Rays.CAPACITY];

    // Origin x direction, the moments of rays' lines; and bounds on the rays' errors and distances from the origin.
    final Vectors moment = new Vectors();
    double originError;
    double directionError;
    double farthest;
}
