package raytracer.tracer.primitive;

import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;

/** An infinite plane, as single rays see it: a point p, the unit normal n, and the surface's index. */
final class Plane {

    private final int surface;
    private final double px, py, pz;
    private final double nx, ny, nz;

    Plane(Shape.Plane plane, int surface) {
        this.surface = surface;
        Vector p = plane.point(), n = plane.normal().unit();
        px = p.x();
        py = p.y();
        pz = p.z();
        nx = n.x();
        ny = n.y();
        nz = n.z();
    }

    int surface() {
        return surface;
    }

    /** The distance at which a ray hits the plane; NaN if it does not, or farther away than {@link Rays#maxDistance}. */
    double distance(Rays rays, int i) {
        double offset = offset(rays, i), cosine = cosine(rays, i), t = offset / cosine;
        boolean isHit = t > 0 && t <= rays.maxDistance(i) && Math.abs(cosine) > Rounding.cosine(rays.directionError[i])
                && rays.source[i] != surface && Math.abs(offset) > offsetError(rays, i);
        return isHit ? t : Double.NaN;
    }

    /** Bounds the error of that distance. */
    double distanceError(Rays rays, int i, double t) {
        return Rounding.planeDistance(
                rays.originError[i], rays.directionError[i], products(rays, i), t, cosine(rays, i));
    }

    void moveToHit(Rays rays, int i) {
        rays.moveToPlane(i, products(rays, i), nx, ny, nz);
    }

    /** 1 if a light is on the side to which the normal points, -1 if on the other, 0 if in the plane. */
    int sideOf(LightSource light) {
        if (light.directional()) {
            double cosine = light.x() * nx + light.y() * ny + light.z() * nz;
            return Math.abs(cosine) > Rounding.cosine(2 * Rounding.U) ? (int) Math.signum(cosine) : 0;
        }
        double x = light.x() - px, y = light.y() - py, z = light.z() - pz;
        double height = x * nx + y * ny + z * nz;
        double bound = Rounding.planeOffset(light.positionError(), products(x, y, z));
        return Math.abs(height) > bound ? (int) Math.signum(height) : 0;
    }

    /**
     * Whether a ray has arrived on the other side of the plane than a light, and clearly not on it.
     *
     * @param side of the light
     */
    boolean isBetween(Rays rays, int i, int side) {
        double below = side * offset(rays, i);
        return below > 0 && rays.hit[i] != surface && below > offsetError(rays, i);
    }

    /** (p - o) . n */
    private double offset(Rays rays, int i) {
        return (px - rays.ox[i]) * nx + (py - rays.oy[i]) * ny + (pz - rays.oz[i]) * nz;
    }

    /** d . n */
    private double cosine(Rays rays, int i) {
        return rays.dx[i] * nx + rays.dy[i] * ny + rays.dz[i] * nz;
    }

    /** |x nx| + |y ny| + |z nz| of p, seen from where a ray starts. */
    private double products(Rays rays, int i) {
        return products(px - rays.ox[i], py - rays.oy[i], pz - rays.oz[i]);
    }

    private double products(double x, double y, double z) {
        return Math.abs(x * nx) + Math.abs(y * ny) + Math.abs(z * nz);
    }

    /** Bounds the error of the offset, from where a ray starts or has arrived. */
    private double offsetError(Rays rays, int i) {
        return Rounding.planeOffset(rays.originError[i], products(rays, i)) + rays.slide[i] * Math.abs(cosine(rays, i));
    }
}
