package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** Where rays hit a sphere: points, normals, and bounds on their errors. */
record SphereHits(double cx, double cy, double cz, double r) {

    SphereHits(Shape.Sphere sphere) {
        this(sphere.centre().x(), sphere.centre().y(), sphere.centre().z(), sphere.radius());
    }

    /** A part of {@link #moveToHits}: three, called in one place, so that HotSpot inlines none and compiles each alone. */
    private interface Step {

        void run(SphereHits sphere, Rays rays, int from, int to, Workspace workspace);
    }

    private static final List<Step> STEPS = List.of(SphereHits::measureAlong, SphereHits::bound, SphereHits::move);

    /** Moves rays, from one index to another, that all hit the sphere there, as {@link Surfaces#moveToHits} does. */
    void moveToHits(Rays rays, int from, int to, Workspace workspace) {
        for (int step = 0; step < 3; step++) {
            STEPS.get(step).run(this, rays, from, to, workspace);
        }
    }

    private void measureAlong(Rays rays, int from, int to, Workspace workspace) {
        rays.direction.dotDifference(rays.origin, cx, cy, cz, workspace.along, from, to);
        rays.origin.l1Norm(cx, cy, cz, workspace.l1Norm, from, to);
    }

    /** Bounds how far off the points are, but for what they will round by. */
    private void bound(Rays rays, int from, int to, Workspace workspace) {
        double[] t = rays.distance, along = workspace.along, l1Norm = workspace.l1Norm;
        double[] half = workspace.half, part = workspace.part;
        for (int i = from; i < to; i++) {
            half[i] = Math.abs(t[i] + along[i]);
            part[i] = Rounding.spherePart(half[i], along[i], t[i]);
        }
        boundSinks(l1Norm, part, t, rays.originError, from, to);
        boundSlides(rays, from, to, workspace);
    }

    private void boundSinks(double[] l1Norm, double[] part, double[] t, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = Rounding.sphereSink(l1Norm[i], r, part[i], t[i]);
        }
    }

    private void boundSlides(Rays rays, int from, int to, Workspace workspace) {
        double[] half = workspace.half, part = workspace.part, l1Norm = workspace.l1Norm;
        double[] t = rays.distance, sink = rays.originError, slide = rays.slide;
        for (int i = from; i < to; i++) {
            slide[i] = Rounding.sphereSlide(l1Norm[i], r, half[i], part[i], t[i], sink[i]);
        }
    }

    private void move(Rays rays, int from, int to, Workspace workspace) {
        double[] l1Norm = workspace.l1Norm;
        rays.origin.addScaled(rays.distance, rays.direction, from, to);
        rays.origin.l1Norm(0, 0, 0, l1Norm, from, to);
        boundErrors(rays, l1Norm, from, to);
        // Not centre and radius times normal: near a huge sphere's surface that would round by much more.
        rays.normal.setDifference(rays.origin, cx, cy, cz, from, to);
        rays.normal.normalise(l1Norm, from, to);
    }

    private void boundErrors(Rays rays, double[] l1Norm, int from, int to) {
        double[] t = rays.distance, error = rays.originError, slide = rays.slide, normalError = rays.normalError;
        double reciprocal = 1 / r;
        for (int i = from; i < to; i++) {
            // Where the slide is not granted in full, a point leaves the sphere by up to three times the sink.
            error[i] = 3 * error[i] + Rounding.point(t[i], l1Norm[i]);
            normalError[i] = (error[i] + slide[i]) * reciprocal + 4 * Rounding.U;
        }
    }
}
