package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.PowerOfPoint;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.Bounds;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/**
 * Spheres. Whether a ray hits one is decided by the perpendicular from the centre to the ray, which loses no digits to
 * distance (Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems,
 * 2019, chapter 7); where it does, by the power of the origin, which loses none to size ({@link PowerOfPoint}).
 */
public final class Spheres extends Surfaces {

    /** Of the tree: a ray tries a box much faster than a sphere. */
    public static final int LEAF_SIZE = 1;

    private final SphereArray data;
    private final PlainSphere plain;

    /** @param spheres in the order of the tree's leaves */
    public Spheres(List<Shape.Sphere> spheres, int firstSurface, Bvh bvh) {
        super("spheres", firstSurface, bvh);
        data = SphereArray.of(spheres);
        plain = new PlainSphere(data, firstSurface);
    }

    public static Bounds bounds(List<Shape.Sphere> spheres) {
        return SphereArray.bounds(spheres);
    }

    @Override
    protected double distance(Rays rays, int i, int k) {
        double cx = data.x(k), cy = data.y(k), cz = data.z(k), r = data.radius(k);
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = rays.dx[i], dy = rays.dy[i], dz = rays.dz[i];
        double along = x * dx + y * dy + z * dz;
        double ex = x - along * dx, ey = y - along * dy, ez = z - along * dz;
        double square = r * r - (ex * ex + ey * ey + ez * ez);
        double l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double originError = rays.originError[i], directionError = rays.directionError[i];
        double bound = Rounding.sphereSquare(originError, directionError, l1Norm, r, along);
        if (square < -bound || PlainSphere.isClear(square, r, originError)) {
            return Double.NaN;
        }
        double alongError = Rounding.along(originError, directionError, l1Norm);
        double power = rays.source[i] == surface(k)
                ? 0
                : PowerOfPoint.of(rays.ox[i], rays.oy[i], rays.oz[i], cx, cy, cz, r);
        double powerError = Rounding.power(originError, r, rays.slide[i], along);
        if (Math.abs(power) <= powerError) {
            // The ray starts on the sphere: only the other hit counts, if it goes inwards.
            return along < -alongError - rays.slide[i] ? atMost(rays.maxDistance(i), -2 * along) : Double.NaN;
        }
        if (square < bound) {
            double error = Rounding.tangentSquare(along, alongError, power, Rounding.power(originError, r, 0, 0));
            square = error < bound ? along * along - power : square;
            if (square < -Math.min(error, bound)) {
                return Double.NaN;
            }
        }
        return atMost(rays.maxDistance(i), distance(power, along, Math.sqrt(Math.max(0, square))));
    }

    private static double atMost(double max, double t) {
        return t <= max ? t : Double.NaN;
    }

    @Override
    public void intersectAll(Rays rays, int from, int to, int k, Workspace workspace) {
        double power = rays.leaveEye ? PowerOfPoint.of(rays.ox[from], rays.oy[from], rays.oz[from],
                data.x(k), data.y(k), data.z(k), data.radius(k)) : 0;
        if (power > 0) {
            plain.intersectFromEye(rays, k, power, workspace, from, to);
        } else {
            plain.intersect(rays, k, workspace, from, to);
        }
        for (int n = 0; n < workspace.doubtfulCount; n++) {
            intersect(rays, workspace.doubtful[n], k);
        }
    }

    @Override
    public void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Workspace workspace) {
        int lightSide = sideOfLight(shadows.light, k);
        if (rays.hit[from] == surface(k) && rays.haveHitTheSame(from, to)) {
            plain.listInwards(rays, shadows, k, workspace, from, to);
        } else {
            plain.occlude(rays, shadows, k, lightSide > 0, workspace, from, to);
        }
        for (int n = 0; n < workspace.doubtfulCount; n++) {
            int i = workspace.doubtful[n];
            shadows.unoccluded[i] = !blocks(rays, shadows, i, k, lightSide);
        }
    }

    @Override
    protected double distanceError(Rays rays, int i, int k, double t) {
        double x = rays.ox[i] - data.x(k), y = rays.oy[i] - data.y(k), z = rays.oz[i] - data.z(k);
        double along = x * rays.dx[i] + y * rays.dy[i] + z * rays.dz[i];
        return Rounding.sphereDistance(rays.originError[i], rays.directionError[i],
                Math.abs(x) + Math.abs(y) + Math.abs(z), data.radius(k), Math.abs(t + along), along, t);
    }

    /**
     * The distance to the first hit, not positive if there is none. The two distances multiply to the power and add
     * up to -2 along; each is computed in the way that subtracts nothing alike.
     */
    private static double distance(double power, double along, double half) {
        if (power > 0) {
            return along < 0 ? power / (half - along) : -1;
        }
        return along <= 0 ? half - along : -power / (half + along);
    }

    /**
     * Whether a sphere is hit strictly between a point and a light. It follows from which of them are outside, inside
     * and on the sphere, and needs no distance.
     */
    @Override
    public boolean blocks(Rays rays, ShadowRays shadows, int i, int k) {
        return blocks(rays, shadows, i, k, sideOfLight(shadows.light, k));
    }

    private boolean blocks(Rays rays, ShadowRays shadows, int i, int k, int lightSide) {
        double cx = data.x(k), cy = data.y(k), cz = data.z(k), r = data.radius(k);
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = shadows.dx[i], dy = shadows.dy[i], dz = shadows.dz[i];
        double along = x * dx + y * dy + z * dz;
        double l1Norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double originError = rays.originError[i];
        double slide = rays.slide[i];
        double alongError = Rounding.along(originError, 2 * Rounding.U, l1Norm) + slide;
        int side = 0;
        if (rays.hit[i] != surface(k)) {
            double ex = x - along * dx, ey = y - along * dy, ez = z - along * dz;
            double square = r * r - (ex * ex + ey * ey + ez * ez);
            double bound = Rounding.sphereSquare(shadows.originError[i], 2 * Rounding.U, l1Norm, r, along);
            if (square < -bound || PlainSphere.isClear(square, r, shadows.originError[i])) {
                return false;
            }
            double slideAlong = x * rays.dx[i] + y * rays.dy[i] + z * rays.dz[i];
            double powerError = Rounding.power(originError, r, slide, slideAlong);
            double power = power(rays.ox[i], rays.oy[i], rays.oz[i], powerError, k);
            side = sign(power, powerError);
            double error = Rounding.tangentSquare(along, alongError, power, powerError);
            if (side > 0 && square < bound && error < bound && along * along - power < -error) {
                return false;
            }
        }
        if (side == 0) {
            // It must go inwards, and come out again before the light.
            return along < -alongError && lightSide > 0;
        }
        if (side < 0 || lightSide < 0) {
            return side * lightSide < 0;
        }
        // The middle of the way through the sphere must be before the light: clearly so, if the light is on the sphere.
        return along < 0 && -along < shadows.distance[i]
                - (lightSide > 0 ? 0 : alongError + Rounding.lightDistance(shadows.light.positionError(), shadows.distance[i]));
    }

    private int sideOfLight(LightSource light, int k) {
        if (light.directional()) {
            return 1;
        }
        double error = Rounding.power(light.positionError(), data.radius(k), 0, 0);
        return sign(power(light.x(), light.y(), light.z(), error, k), error);
    }

    /** 1 if a point is outside a sphere, -1 inside, 0 on it. */
    private static int sign(double power, double error) {
        return Math.abs(power) <= error ? 0 : power > 0 ? 1 : -1;
    }

    /** The power of a point, exactly enough to compare with a bound. */
    private double power(double px, double py, double pz, double bound, int k) {
        double cx = data.x(k), cy = data.y(k), cz = data.z(k), r = data.radius(k);
        double x = px - cx, y = py - cy, z = pz - cz;
        double square = x * x + y * y + z * z;
        double power = square - r * r;
        return Math.abs(power) <= bound + Rounding.plainPower(square, r)
                ? PowerOfPoint.of(px, py, pz, cx, cy, cz, r) : power;
    }

    @Override
    public boolean mayShowWithin(RayBundle bundle, int k) {
        return !bundle.isClearOfSphere(new Vector(data.x(k), data.y(k), data.z(k)), data.radius(k));
    }

    @Override
    public void moveToHits(Rays rays, int from, int to, Workspace workspace) {
        for (int i = from; i < to; i++) {
            moveToHit(rays, i, number(rays.hit[i]));
        }
        rays.normal.normalise(workspace.square, from, to);
    }

    private void moveToHit(Rays rays, int i, int k) {
        double cx = data.x(k), cy = data.y(k), cz = data.z(k), r = data.radius(k), t = rays.distance[i];
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = rays.dx[i], dy = rays.dy[i], dz = rays.dz[i];
        double slide = Rounding.sphereSlide(Math.abs(x) + Math.abs(y) + Math.abs(z), r, x * dx + y * dy + z * dz, t);
        double px = rays.ox[i] + t * dx, py = rays.oy[i] + t * dy, pz = rays.oz[i] + t * dz;
        double error = Rounding.point(t, Math.abs(px) + Math.abs(py) + Math.abs(pz));
        rays.ox[i] = px;
        rays.oy[i] = py;
        rays.oz[i] = pz;
        // Not centre and radius times normal: near a huge sphere's surface that would round by much more.
        rays.nx[i] = px - cx;
        rays.ny[i] = py - cy;
        rays.nz[i] = pz - cz;
        rays.slide[i] = slide;
        rays.originError[i] = error;
        rays.normalError[i] = (error + slide) / r + 4 * Rounding.U;
    }
}
