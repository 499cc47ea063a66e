package raytracer.tracer;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/**
 * Spheres. Whether a ray meets one is decided by the perpendicular from the centre to the ray, which loses no digits to
 * distance (Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems,
 * 2019, chapter 7); where it does, by the power of the origin, which loses none to size ({@link PowerOfPoint}).
 */
final class Spheres extends BoundedSurfaces {

    /** Numbers of one sphere in {@link #data}: centre and radius. */
    private static final int STRIDE = 4;

    /**
     * Of r^2: a point whose distance's square exceeds r^2 by more than this is clear of the sphere, and so is a ray
     * whose perpendicular's does: errors are smaller for any sphere that is larger than the ray is thick.
     */
    private static final double CLEAR = 0.25;

    private final double[] data;

    /** @param spheres in the order of the tree's leaves */
    Spheres(List<Shape.Sphere> spheres, int firstSlot, Bvh bvh) {
        super(firstSlot, bvh);
        int count = spheres.size();
        data = new double[STRIDE * count];
        for (int k = 0; k < count; k++) {
            Vector c = spheres.get(k).centre();
            data[STRIDE * k] = c.x();
            data[STRIDE * k + 1] = c.y();
            data[STRIDE * k + 2] = c.z();
            data[STRIDE * k + 3] = spheres.get(k).radius();
        }
    }

    static Bounds bounds(List<Shape.Sphere> spheres) {
        return (k, box) -> {
            Vector c = spheres.get(k).centre();
            double r = spheres.get(k).radius();
            box[0] = c.x() - r;
            box[1] = c.y() - r;
            box[2] = c.z() - r;
            box[3] = c.x() + r;
            box[4] = c.y() + r;
            box[5] = c.z() + r;
        };
    }

    @Override
    void meet(Rays rays, int i, int k) {
        double cx = data[STRIDE * k], cy = data[STRIDE * k + 1], cz = data[STRIDE * k + 2], r = data[STRIDE * k + 3];
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = rays.dx[i], dy = rays.dy[i], dz = rays.dz[i];
        double along = x * dx + y * dy + z * dz;
        double ex = x - along * dx, ey = y - along * dy, ez = z - along * dz;
        double square = r * r - (ex * ex + ey * ey + ez * ez);
        double reach = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double originError = rays.originError[i], directionError = rays.directionError[i];
        if (square < 0 && square < -Rounding.sphereSquare(originError, directionError, reach, r, along)) {
            return;
        }
        double half = Math.sqrt(Math.max(0, square));
        double power = rays.source[i] == slot(k)
                ? 0
                : PowerOfPoint.of(rays.ox[i], rays.oy[i], rays.oz[i], cx, cy, cz, r);
        double t;
        if (Math.abs(power) <= Rounding.power(originError, r)) {
            // The ray starts on the sphere: only the other meeting counts, if it goes inwards.
            t = along < -Rounding.along(originError, directionError, reach) ? -2 * along : -1;
        } else {
            t = distance(power, along, half);
        }
        if (t > 0 && t <= rays.reach(i)) {
            rays.offer(i, slot(k), t);
        }
    }

    @Override
    void meetAll(Rays rays, int k, Scratch scratch) {
        passBy(rays, rays.dx, rays.dy, rays.dz, k, scratch);
        double clear = -CLEAR * data[STRIDE * k + 3] * data[STRIDE * k + 3];
        for (int i = 0; i < rays.count; i++) {
            if (scratch.square[i] >= clear) {
                meet(rays, i, k);
            }
        }
    }

    @Override
    void blockAll(Rays rays, ShadowRays shadows, int k, Scratch scratch) {
        passBy(rays, shadows.dx, shadows.dy, shadows.dz, k, scratch);
        double clear = -CLEAR * data[STRIDE * k + 3] * data[STRIDE * k + 3];
        for (int i = 0; i < rays.count; i++) {
            if (scratch.square[i] >= clear && shadows.open[i]) {
                shadows.open[i] = !blocks(rays, shadows, i, k);
            }
        }
    }

    /** Computes for all rays r^2 less the square of the perpendicular, in short loops over arrays that C2 can vectorise. */
    private void passBy(Rays rays, double[] dx, double[] dy, double[] dz, int k, Scratch scratch) {
        double cx = data[STRIDE * k], cy = data[STRIDE * k + 1], cz = data[STRIDE * k + 2], r = data[STRIDE * k + 3];
        double[] ox = rays.ox, oy = rays.oy, oz = rays.oz, along = scratch.along, square = scratch.square;
        int count = rays.count;
        for (int i = 0; i < count; i++) {
            along[i] = (ox[i] - cx) * dx[i] + (oy[i] - cy) * dy[i] + (oz[i] - cz) * dz[i];
        }
        for (int i = 0; i < count; i++) {
            double ex = ox[i] - cx - along[i] * dx[i];
            double ey = oy[i] - cy - along[i] * dy[i];
            double ez = oz[i] - cz - along[i] * dz[i];
            square[i] = r * r - (ex * ex + ey * ey + ez * ez);
        }
    }

    @Override
    public double distanceError(Rays rays, int i, int slot, double t) {
        int k = STRIDE * number(slot);
        double x = rays.ox[i] - data[k], y = rays.oy[i] - data[k + 1], z = rays.oz[i] - data[k + 2];
        double along = x * rays.dx[i] + y * rays.dy[i] + z * rays.dz[i];
        return Rounding.sphereDistance(rays.originError[i], rays.directionError[i],
                Math.abs(x) + Math.abs(y) + Math.abs(z), data[k + 3], Math.abs(t + along), along, t);
    }

    /**
     * The distance to the first meeting, not positive if there is none. The two distances multiply to the power and add
     * up to -2 along; each is computed in the way that subtracts nothing alike.
     */
    private static double distance(double power, double along, double half) {
        if (power > 0) {
            return along < 0 ? power / (half - along) : -1;
        }
        return along <= 0 ? half - along : -power / (half + along);
    }

    /**
     * Whether a sphere is met strictly between a point and a light. It follows from which of them are outside, inside
     * and on the sphere, and needs no distance.
     */
    @Override
    boolean blocks(Rays rays, ShadowRays shadows, int i, int k) {
        double cx = data[STRIDE * k], cy = data[STRIDE * k + 1], cz = data[STRIDE * k + 2], r = data[STRIDE * k + 3];
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double dx = shadows.dx[i], dy = shadows.dy[i], dz = shadows.dz[i];
        double along = x * dx + y * dy + z * dz;
        double reach = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double originError = rays.originError[i];
        int side = 0;
        if (rays.hit[i] != slot(k)) {
            double ex = x - along * dx, ey = y - along * dy, ez = z - along * dz;
            double square = r * r - (ex * ex + ey * ey + ez * ez);
            if (square < 0 && square < -Rounding.sphereSquare(originError, 2 * Rounding.U, reach, r, along)) {
                return false;
            }
            side = side(rays.ox[i], rays.oy[i], rays.oz[i], originError, k);
        }
        if (side == 0) {
            // It must go inwards, and come out again before the light.
            return along < -Rounding.along(originError, 2 * Rounding.U, reach) && sideOfLamp(shadows.lamp, k) > 0;
        }
        int lampSide = sideOfLamp(shadows.lamp, k);
        return side < 0 || lampSide < 0 ? side * lampSide < 0 : along < 0 && -along < shadows.distance[i];
    }

    private int sideOfLamp(Lamp lamp, int k) {
        return lamp.directional() ? 1 : side(lamp.x(), lamp.y(), lamp.z(), lamp.positionError(), k);
    }

    /** 1 if a point is outside a sphere, -1 inside, 0 on it. */
    private int side(double px, double py, double pz, double error, int k) {
        double cx = data[STRIDE * k], cy = data[STRIDE * k + 1], cz = data[STRIDE * k + 2], r = data[STRIDE * k + 3];
        double x = px - cx, y = py - cy, z = pz - cz;
        double square = x * x + y * y + z * z;
        if (square > r * r * (1 + CLEAR)) {
            return 1;
        }
        double power = PowerOfPoint.of(px, py, pz, cx, cy, cz, r);
        return Math.abs(power) <= Rounding.power(error, r) ? 0 : power > 0 ? 1 : -1;
    }

    @Override
    public void arrive(Rays rays, int i) {
        int k = STRIDE * number(rays.hit[i]);
        double cx = data[k], cy = data[k + 1], cz = data[k + 2], r = data[k + 3];
        double x = rays.ox[i] - cx, y = rays.oy[i] - cy, z = rays.oz[i] - cz;
        double reach = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double along = x * rays.dx[i] + y * rays.dy[i] + z * rays.dz[i];
        double t = rays.distance[i];
        x += t * rays.dx[i];
        y += t * rays.dy[i];
        z += t * rays.dz[i];
        double length = Math.sqrt(x * x + y * y + z * z);
        rays.nx[i] = x / length;
        rays.ny[i] = y / length;
        rays.nz[i] = z / length;
        rays.ox[i] = cx + r * rays.nx[i];
        rays.oy[i] = cy + r * rays.ny[i];
        rays.oz[i] = cz + r * rays.nz[i];
        rays.originError[i] = Rounding.spherePosition(
                Math.abs(cx) + Math.abs(cy) + Math.abs(cz), reach, r, Math.abs(t + along), along, t);
        rays.normalError[i] = rays.originError[i] / r;
    }
}
