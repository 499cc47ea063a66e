package raytracer.tracer.primitive;

import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Workspace;

/** Moves rays to where they hit spheres. */
final class SphereHits implements Kernel {

    private final SphereArray spheres;
    private final int firstSurface;
    private final Rays rays;
    /** By ray the sphere that it has hit, in the order of a sphere's numbers. */
    private final double[][] sphere;
    private final Kernel kernels;

    SphereHits(SphereArray spheres, int firstSurface, Rays rays, Workspace workspace) {
        this.spheres = spheres;
        this.firstSurface = firstSurface;
        this.rays = rays;
        Vectors centre = workspace.centre;
        double[] radius = workspace.radius, l1Norm = workspace.l1Norm, along = workspace.along, spare = workspace.spare;
        sphere = new double[][] {centre.x(), centre.y(), centre.z(), radius};
        kernels = new Kernel.InTurn(
                Kernel.subtract(rays.origin, centre, rays.normal),
                new Kernel.L1Norm(rays.normal, l1Norm),
                new Kernel.Dot(rays.normal, rays.direction, along),
                // Not centre and radius times normal: near a huge sphere's surface that would round by much more.
                Kernel.addProduct(rays.origin, 1, rays.distance, rays.direction, rays.origin),
                Kernel.subtract(rays.origin, centre, rays.normal),
                new Kernel.Length(rays.normal, spare),
                new Kernel.DivideByLength(rays.normal, spare),
                new Kernel.L1Norm(rays.origin, spare),
                new Rounding.SphereErrors(l1Norm, along, radius, rays.distance, spare, rays.slide, rays.originError,
                        rays.normalError));
    }

    @Override
    public void run(int from, int to) {
        boolean same = rays.haveHitTheSame(from, to);
        for (int number = 0; number < SphereArray.STRIDE; number++) {
            if (same) {
                Kernel.run(new Kernel.Fill(sphere[number], spheres.numbers()[at(from) + number]), from, to);
            } else {
                gather(sphere[number], number, from, to);
            }
        }
        Kernel.run(kernels, from, to);
    }

    private void gather(double[] out, int number, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = spheres.numbers()[at(i) + number];
        }
    }

    /** Where the numbers of the sphere are that a ray has hit. */
    private int at(int ray) {
        return SphereArray.STRIDE * (rays.hit[ray] - firstSurface);
    }
}
