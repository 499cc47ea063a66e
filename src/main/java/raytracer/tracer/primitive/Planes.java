package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** Infinite planes, each a point p and the unit normal n: too wide for a tree. */
public final class Planes extends Surfaces {

    private final Vector[] point;
    private final Vector[] normal;

    public Planes(List<Shape.Plane> planes, int firstSurface) {
        super("planes", firstSurface, Bvh.withoutTree(planes.size()));
        point = planes.stream().map(Shape.Plane::point).toArray(Vector[]::new);
        normal = planes.stream().map(plane -> plane.normal().unit()).toArray(Vector[]::new);
    }

    @Override
    protected double distance(Rays rays, int i, int k) {
        double offset = offset(rays, i, k), cosine = cosine(rays, i, k), t = offset / cosine;
        boolean isHit = t > 0 && t <= rays.maxDistance(i) && !isParallel(rays, i, k, cosine)
                && rays.source[i] != surface(k) && Math.abs(offset) > offsetError(rays, i, k);
        return isHit ? t : Double.NaN;
    }

    /** Whether rounding hides on which side a ray approaches the plane. */
    private boolean isParallel(Rays rays, int i, int k, double cosine) {
        if (Math.abs(cosine) > Rounding.cosine(rays.directionError[i])) {
            return false;
        }
        Vector d = rays.directionTerms(i), n = normal[k];
        return d == null || Math.abs(cosine)
                <= Rounding.eyeCosine(d.x() * Math.abs(n.x()) + d.y() * Math.abs(n.y()) + d.z() * Math.abs(n.z()));
    }

    @Override
    protected double distanceError(Rays rays, int i, int k, double t) {
        return Rounding.planeDistance(
                rays.originError[i], rays.directionError[i], products(rays, i, k), t, cosine(rays, i, k));
    }

    @Override
    public void intersectAll(Rays rays, int from, int to, int k, Workspace workspace) {
        for (int i = from; i < to; i++) {
            double t = distance(rays, i, k);
            if (t > 0) {
                rays.record(i, surface(k), t);
            }
        }
    }

    @Override
    public void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Workspace workspace) {
        int side = sideOf(shadows.light, k);
        for (int i = from; i < to; i++) {
            if (shadows.unoccluded[i] && isBetween(rays, i, k, side)) {
                shadows.unoccluded[i] = false;
            }
        }
    }

    @Override
    public boolean blocks(Rays rays, ShadowRays shadows, int i, int k) {
        return isBetween(rays, i, k, sideOf(shadows.light, k));
    }

    /** 1 if a light is on the side to which the normal points, -1 if on the other, 0 if in the plane. */
    private int sideOf(LightSource light, int k) {
        Vector n = normal[k], p = point[k];
        if (light.directional()) {
            double cosine = light.x() * n.x() + light.y() * n.y() + light.z() * n.z();
            return Math.abs(cosine) > Rounding.cosine(2 * Rounding.U) ? (int) Math.signum(cosine) : 0;
        }
        double x = light.x() - p.x(), y = light.y() - p.y(), z = light.z() - p.z();
        double height = x * n.x() + y * n.y() + z * n.z();
        double bound = Rounding.planeOffset(light.positionError(), products(x, y, z, n));
        return Math.abs(height) > bound ? (int) Math.signum(height) : 0;
    }

    /**
     * Whether a ray has arrived on the other side of the plane than a light, and clearly not on it.
     *
     * @param side of the light
     */
    private boolean isBetween(Rays rays, int i, int k, int side) {
        double below = side * offset(rays, i, k);
        return below > 0 && rays.hit[i] != surface(k) && below > offsetError(rays, i, k);
    }

    @Override
    public void moveToHits(Rays rays, int from, int to, Workspace workspace) {
        for (int i = from; i < to; i++) {
            int k = number(rays.hit[i]);
            rays.moveToPlane(i, products(rays, i, k), normal[k].x(), normal[k].y(), normal[k].z());
        }
    }

    /** (p - o) . n */
    private double offset(Rays rays, int i, int k) {
        Vector p = point[k], n = normal[k];
        return (p.x() - rays.ox[i]) * n.x() + (p.y() - rays.oy[i]) * n.y() + (p.z() - rays.oz[i]) * n.z();
    }

    /** d . n */
    private double cosine(Rays rays, int i, int k) {
        Vector n = normal[k];
        return rays.dx[i] * n.x() + rays.dy[i] * n.y() + rays.dz[i] * n.z();
    }

    /** |x nx| + |y ny| + |z nz| of p, seen from where a ray starts. */
    private double products(Rays rays, int i, int k) {
        Vector p = point[k];
        return products(p.x() - rays.ox[i], p.y() - rays.oy[i], p.z() - rays.oz[i], normal[k]);
    }

    private static double products(double x, double y, double z, Vector n) {
        return Math.abs(x * n.x()) + Math.abs(y * n.y()) + Math.abs(z * n.z());
    }

    /** Bounds the error of the offset, from where a ray starts or has arrived. */
    private double offsetError(Rays rays, int i, int k) {
        return Rounding.planeOffset(rays.originError[i], products(rays, i, k))
                + rays.slide[i] * Math.abs(cosine(rays, i, k));
    }
}
