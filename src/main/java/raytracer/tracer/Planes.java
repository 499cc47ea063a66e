package raytracer.tracer;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** Infinite planes: few, and met by nearly every ray, so every ray tries each. */
final class Planes implements Surfaces {

    private final int firstSlot;
    private final int count;
    private final double[] px, py, pz;
    private final double[] nx, ny, nz;

    Planes(List<Shape.Plane> planes, int firstSlot) {
        this.firstSlot = firstSlot;
        count = planes.size();
        px = new double[count];
        py = new double[count];
        pz = new double[count];
        nx = new double[count];
        ny = new double[count];
        nz = new double[count];
        for (int k = 0; k < count; k++) {
            Vector p = planes.get(k).point(), n = planes.get(k).normal().unit();
            px[k] = p.x();
            py[k] = p.y();
            pz[k] = p.z();
            nx[k] = n.x();
            ny[k] = n.y();
            nz[k] = n.z();
        }
    }

    @Override
    public boolean owns(int slot) {
        return slot >= firstSlot && slot < firstSlot + count;
    }

    @Override
    public void findNearest(Rays rays, Scratch scratch) {
        for (int k = 0; k < count; k++) {
            for (int i = 0; i < rays.count; i++) {
                double x = px[k] - rays.ox[i], y = py[k] - rays.oy[i], z = pz[k] - rays.oz[i];
                double offset = x * nx[k] + y * ny[k] + z * nz[k];
                double cosine = rays.dx[i] * nx[k] + rays.dy[i] * ny[k] + rays.dz[i] * nz[k];
                double t = offset / cosine;
                if (!(t > 0 && t <= rays.reach(i)) || Math.abs(cosine) <= Rounding.cosine(rays.directionError[i])
                        || rays.source[i] == firstSlot + k) {
                    continue;
                }
                double reach = Math.abs(x) + Math.abs(y) + Math.abs(z);
                if (Math.abs(offset) > Rounding.planeOffset(rays.originError[i], reach)) {
                    rays.offer(i, firstSlot + k, t);
                }
            }
        }
    }

    @Override
    public double distanceError(Rays rays, int i, int slot, double t) {
        int k = slot - firstSlot;
        double reach = Math.abs(px[k] - rays.ox[i]) + Math.abs(py[k] - rays.oy[i]) + Math.abs(pz[k] - rays.oz[i]);
        double cosine = rays.dx[i] * nx[k] + rays.dy[i] * ny[k] + rays.dz[i] * nz[k];
        return Rounding.planeDistance(rays.originError[i], rays.directionError[i], reach, t, cosine);
    }

    @Override
    public void block(Rays rays, ShadowRays shadows, int from, int to, Scratch scratch) {
        Lamp lamp = shadows.lamp;
        for (int k = 0; k < count; k++) {
            double lampX = px[k] - lamp.x(), lampY = py[k] - lamp.y(), lampZ = pz[k] - lamp.z();
            double lampOffset = lampX * nx[k] + lampY * ny[k] + lampZ * nz[k];
            double lampBound = Rounding.planeOffset(
                    lamp.positionError(), Math.abs(lampX) + Math.abs(lampY) + Math.abs(lampZ));
            for (int i = from; i < to; i++) {
                if (!shadows.open[i] || rays.hit[i] == firstSlot + k) {
                    continue;
                }
                double x = px[k] - rays.ox[i], y = py[k] - rays.oy[i], z = pz[k] - rays.oz[i];
                double offset = x * nx[k] + y * ny[k] + z * nz[k];
                boolean between;
                if (lamp.directional()) {
                    double cosine = shadows.dx[i] * nx[k] + shadows.dy[i] * ny[k] + shadows.dz[i] * nz[k];
                    between = Math.abs(cosine) > Rounding.cosine(2 * Rounding.U)
                            && (offset > 0 && cosine > 0 || offset < 0 && cosine < 0);
                } else {
                    // The light and the point are on different sides, and the light is not on the plane.
                    between = Math.abs(lampOffset) > lampBound
                            && (offset > 0 && lampOffset < 0 || offset < 0 && lampOffset > 0);
                }
                if (between && Math.abs(offset) > Rounding.planeOffset(
                        rays.originError[i], Math.abs(x) + Math.abs(y) + Math.abs(z))) {
                    shadows.open[i] = false;
                }
            }
        }
    }

    @Override
    public boolean isOfOneSurface() {
        return false;
    }

    @Override
    public void arrive(Rays rays, int from, int to, Scratch scratch) {
        for (int i = from; i < to; i++) {
            int k = rays.hit[i] - firstSlot;
            double reach = Math.abs(px[k] - rays.ox[i]) + Math.abs(py[k] - rays.oy[i]) + Math.abs(pz[k] - rays.oz[i]);
            rays.arriveOnPlane(i, reach, nx[k], ny[k], nz[k]);
        }
    }
}
