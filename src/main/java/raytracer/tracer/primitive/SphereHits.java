package raytracer.tracer.primitive;

import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.Rays;

/**
 * Takes rays to where they have hit spheres: their origins become those points, with bounds on their errors, and the
 * normals are set.
 */
public final class SphereHits {

    private final double[] data;
    private final int firstSurface;
    private final Rays rays;
    /** By ray the sphere that it has hit, in the order of a sphere's numbers. */
    private final double[][] sphere;
    private final Kernel kernels;

    /** @param data spheres, {@link Spheres#STRIDE} numbers each */
    SphereHits(double[] data, int firstSurface, Rays rays, Workspace workspace) {
        this.data = data;
        this.firstSurface = firstSurface;
        this.rays = rays;
        double[] radius = workspace.radius;
        Vectors centre = new Vectors(workspace.centreX, workspace.centreY, workspace.centreZ);
        sphere = new double[][] {centre.x(), centre.y(), centre.z(), radius};
        kernels = new Kernel.InTurn(
                Kernel.subtract(rays.origin, centre, rays.normal),
                new Kernel.L1Norm(rays.normal, workspace.l1Norm),
                new Kernel.Dot(rays.normal, rays.direction, workspace.along),
                // Not centre and radius times normal: near a huge sphere's surface that would round by much more.
                Kernel.addProduct(rays.origin, 1, rays.distance, rays.direction, rays.origin),
                Kernel.subtract(rays.origin, centre, rays.normal),
                new Kernel.Length(rays.normal, workspace.square),
                new Kernel.DivideByLength(rays.normal, workspace.square),
                Rounding.sphereSlide(workspace.l1Norm, radius, workspace.along, rays.distance, workspace.square, rays.slide),
                new Kernel.L1Norm(rays.origin, workspace.square),
                new Rounding.SpherePoint(rays.distance, workspace.square, rays.slide, radius, rays.originError,
                        rays.normalError));
    }

    void run(int from, int to) {
        boolean same = rays.haveHitTheSame(from, to);
        for (int number = 0; number < Spheres.STRIDE; number++) {
            if (same) {
                Kernel.run(new Kernel.Fill(sphere[number], data[at(from) + number]), from, to);
            } else {
                gather(sphere[number], number, from, to);
            }
        }
        Kernel.run(kernels, from, to);
    }

    private void gather(double[] out, int number, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = data[at(i) + number];
        }
    }

    /** Where the numbers of the sphere are that a ray has hit. */
    private int at(int ray) {
        return Spheres.STRIDE * (rays.hit[ray] - firstSurface);
    }
}
