package raytracer.tracer;

/**
 * Takes rays to where they have met spheres: their origins become those points, with bounds on their errors, and the
 * normals are set.
 */
final class SphereArrival {

    private final double[] data;
    private final int firstSlot;
    private final Rays rays;
    /** By ray the sphere that it has met, in the order of a sphere's numbers. */
    private final double[][] sphere;
    private final Pass passes;

    /** @param data spheres, {@link Spheres#STRIDE} numbers each */
    SphereArrival(double[] data, int firstSlot, Rays rays, Scratch scratch) {
        this.data = data;
        this.firstSlot = firstSlot;
        this.rays = rays;
        double[] radius = scratch.radius;
        Vectors centre = new Vectors(scratch.centreX, scratch.centreY, scratch.centreZ);
        sphere = new double[][] {centre.x(), centre.y(), centre.z(), radius};
        passes = new Pass.InTurn(
                Pass.subtract(rays.origin, centre, rays.normal),
                new Pass.Reach(rays.normal, scratch.reach),
                new Pass.Dot(rays.normal, rays.direction, scratch.along),
                Pass.addProduct(rays.normal, 1, rays.distance, rays.direction, rays.normal),
                new Pass.Length(rays.normal, scratch.square),
                new Pass.DivideByLength(rays.normal, scratch.square),
                Pass.addProduct(centre, 1, radius, rays.normal, rays.origin),
                new Pass.Reach(centre, scratch.square),
                Rounding.spherePosition(scratch.square, scratch.reach, radius, scratch.along, rays.distance,
                        scratch.distance, rays.originError),
                new Pass.Divide(rays.originError, radius, rays.normalError));
    }

    void run(int from, int to) {
        boolean same = rays.haveMetTheSame(from, to);
        for (int number = 0; number < Spheres.STRIDE; number++) {
            if (same) {
                Pass.run(new Pass.Fill(sphere[number], data[at(from) + number]), from, to);
            } else {
                gather(sphere[number], number, from, to);
            }
        }
        Pass.run(passes, from, to);
    }

    private void gather(double[] out, int number, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = data[at(i) + number];
        }
    }

    /** Where the numbers of the sphere are that a ray has met. */
    private int at(int ray) {
        return Spheres.STRIDE * (rays.hit[ray] - firstSlot);
    }
}
