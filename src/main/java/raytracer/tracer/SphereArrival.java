package raytracer.tracer;

/**
 * Takes rays to where they have met spheres, whose centres and radii are in {@link Scratch}: their origins become those
 * points, with bounds on their errors, and the normals are set.
 */
final class SphereArrival {

    private final Pass[] passes;

    SphereArrival(Rays rays, Scratch scratch) {
        Vectors centre = new Vectors(scratch.centreX, scratch.centreY, scratch.centreZ);
        passes = new Pass[] {
            Pass.subtract(rays.origin, centre, rays.normal),
            new Pass.Reach(rays.normal, scratch.reach),
            new Pass.Dot(rays.normal, rays.direction, scratch.along),
            Pass.addProduct(rays.normal, 1, rays.distance, rays.direction, rays.normal),
            new Pass.Length(rays.normal, scratch.square),
            new Pass.DivideByLength(rays.normal, scratch.square),
            Pass.addProduct(centre, 1, scratch.radius, rays.normal, rays.origin),
            new Pass.Reach(centre, scratch.square),
            Rounding.spherePosition(scratch.square, scratch.reach, scratch.radius, scratch.along, rays.distance,
                    scratch.distance, rays.originError),
            new Pass.Divide(rays.originError, scratch.radius, rays.normalError),
        };
    }

    void run(int from, int to) {
        Pass.run(passes, from, to);
    }
}
