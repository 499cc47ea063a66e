package raytracer.tracer.primitive;

import raytracer.tracer.kernel.Pass;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.Rays;

/**
 * Takes rays to where they have met spheres: their origins become those points, with bounds on their errors, and the
 * normals are set.
 */
public final class SphereArrival {

    private final double[] data;
    private final int firstSlot;
    private final Rays rays;
    /** By ray the sphere that it has met, in the order of a sphere's numbers. */
    private final double[][] sphere;
    private final Pass passes;

    /** @param data spheres, {@link Spheres#STRIDE} numbers each */
    SphereArrival(double[] data, int firstSlot, Rays rays, Workspace workspace) {
        this.data = data;
        this.firstSlot = firstSlot;
        this.rays = rays;
        double[] radius = workspace.radius;
        Vectors centre = new Vectors(workspace.centreX, workspace.centreY, workspace.centreZ);
        sphere = new double[][] {centre.x(), centre.y(), centre.z(), radius};
        passes = new Pass.InTurn(
                Pass.subtract(rays.origin, centre, rays.normal),
                new Pass.Reach(rays.normal, workspace.reach),
                new Pass.Dot(rays.normal, rays.direction, workspace.along),
                // Not centre and radius times normal: near a huge sphere's surface that would round by much more.
                Pass.addProduct(rays.origin, 1, rays.distance, rays.direction, rays.origin),
                Pass.subtract(rays.origin, centre, rays.normal),
                new Pass.Length(rays.normal, workspace.square),
                new Pass.DivideByLength(rays.normal, workspace.square),
                Rounding.sphereSlide(workspace.reach, radius, workspace.along, rays.distance, workspace.square, rays.slide),
                new Pass.Reach(rays.origin, workspace.square),
                new Rounding.SpherePoint(rays.distance, workspace.square, rays.slide, radius, rays.originError,
                        rays.normalError));
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
