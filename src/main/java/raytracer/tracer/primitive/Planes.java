package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.UnboundedSurfaces;
import raytracer.tracer.surface.Workspace;

/** Infinite planes. */
public final class Planes implements UnboundedSurfaces {

    private final int firstSurface;
    private final int count;
    private final double[] px, py, pz;
    private final double[] nx, ny, nz;

    public Planes(List<Shape.Plane> planes, int firstSurface) {
        this.firstSurface = firstSurface;
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
    public boolean owns(int surface) {
        return surface >= firstSurface && surface < firstSurface + count;
    }

    @Override
    public Kernel intersecting(Rays rays, Workspace workspace) {
        return (from, to) -> findClosestHits(rays, from, to, workspace);
    }

    private void findClosestHits(Rays rays, int from, int to, Workspace workspace) {
        for (int k = 0; k < count; k++) {
            measure(rays, k, from, to, workspace);
            record(rays, k, workspace, from, to);
        }
    }

    /** By ray: how far the plane is along its normal, how fast the ray goes that way, and so where it hits it. */
    private void measure(Rays rays, int k, int from, int to, Workspace workspace) {
        offsets(rays, k, workspace.offset, from, to);
        cosines(rays, k, workspace.cosine, from, to);
        divide(workspace.offset, workspace.cosine, workspace.distance, from, to);
    }

    // Methods and not kernels, which would be slower here: C2 spills what the loops around them need.

    /** out = (p - o) . n */
    private void offsets(Rays rays, int k, double[] out, int from, int to) {
        double[] ox = rays.ox, oy = rays.oy, oz = rays.oz;
        double x = px[k], y = py[k], z = pz[k], a = nx[k], b = ny[k], c = nz[k];
        for (int i = from; i < to; i++) {
            out[i] = (x - ox[i]) * a + (y - oy[i]) * b + (z - oz[i]) * c;
        }
    }

    /** out = d . n */
    private void cosines(Rays rays, int k, double[] out, int from, int to) {
        double[] dx = rays.dx, dy = rays.dy, dz = rays.dz;
        double a = nx[k], b = ny[k], c = nz[k];
        for (int i = from; i < to; i++) {
            out[i] = dx[i] * a + dy[i] * b + dz[i] * c;
        }
    }

    private static void divide(double[] a, double[] b, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = a[i] / b[i];
        }
    }

    private void record(Rays rays, int k, Workspace workspace, int from, int to) {
        double[] offset = workspace.offset, cosine = workspace.cosine, distance = workspace.distance;
        for (int i = from; i < to; i++) {
            if (isHit(rays, i, k, offset[i], cosine[i], distance[i])) {
                rays.record(i, firstSurface + k, distance[i]);
            }
        }
    }

    private boolean isHit(Rays rays, int i, int k, double offset, double cosine, double t) {
        return t > 0 && t <= rays.maxDistance(i) && Math.abs(cosine) > Rounding.cosine(rays.directionError[i])
                && rays.source[i] != firstSurface + k
                && Math.abs(offset) > Rounding.planeOffset(rays.originError[i], products(rays, i, k))
                        + rays.slide[i] * Math.abs(cosine);
    }

    /** |x nx| + |y ny| + |z nz| of a plane's point, seen from where a ray starts. */
    private double products(Rays rays, int i, int k) {
        return products(px[k] - rays.ox[i], py[k] - rays.oy[i], pz[k] - rays.oz[i], k);
    }

    private double products(double x, double y, double z, int k) {
        return Math.abs(x * nx[k]) + Math.abs(y * ny[k]) + Math.abs(z * nz[k]);
    }

    @Override
    public void collect(Rays rays, int i, Candidates candidates, Workspace workspace) {
        for (int k = 0; k < count; k++) {
            measure(rays, k, i, i + 1, workspace);
            double cosine = workspace.cosine[i], t = workspace.distance[i];
            if (isHit(rays, i, k, workspace.offset[i], cosine, t)) {
                candidates.add(firstSurface + k, t, Rounding.planeDistance(
                        rays.originError[i], rays.directionError[i], products(rays, i, k), t, cosine));
            }
        }
    }

    @Override
    public Kernel blocking(Rays rays, ShadowRays shadows, Workspace workspace) {
        return (from, to) -> block(rays, shadows, from, to, workspace);
    }

    @Override
    public boolean anyBlocksAll(Rays rays, ShadowRays shadows, int[] which) {
        for (int k = 0; k < count; k++) {
            int side = sideOfLight(shadows.light, k);
            int blocked = 0;
            for (int i : which) {
                double offset = (px[k] - rays.ox[i]) * nx[k] + (py[k] - rays.oy[i]) * ny[k]
                        + (pz[k] - rays.oz[i]) * nz[k];
                blocked += isBehind(rays, i, k, side * offset) ? 1 : 0;
            }
            if (blocked == which.length) {
                return true;
            }
        }
        return false;
    }

    private void block(Rays rays, ShadowRays shadows, int from, int to, Workspace workspace) {
        for (int k = 0; k < count; k++) {
            int side = sideOfLight(shadows.light, k);
            if (side != 0) {
                offsets(rays, k, workspace.offset, from, to);
                close(rays, shadows.unoccluded, k, side, workspace.offset, from, to);
            }
        }
    }

    /** 1 if a light is on the side of a plane to which the normal points, -1 if on the other, 0 if in the plane. */
    private int sideOfLight(LightSource light, int k) {
        if (light.directional()) {
            double cosine = light.x() * nx[k] + light.y() * ny[k] + light.z() * nz[k];
            return Math.abs(cosine) > Rounding.cosine(2 * Rounding.U) ? (int) Math.signum(cosine) : 0;
        }
        double x = light.x() - px[k], y = light.y() - py[k], z = light.z() - pz[k];
        double height = x * nx[k] + y * ny[k] + z * nz[k];
        double bound = Rounding.planeOffset(light.positionError(), products(x, y, z, k));
        return Math.abs(height) > bound ? (int) Math.signum(height) : 0;
    }

    /** Occludes the rays from points that are clearly not on the light's side of a plane, nor on the plane. */
    private void close(Rays rays, boolean[] unoccluded, int k, int side, double[] offset, int from, int to) {
        for (int i = from; i < to; i++) {
            if (unoccluded[i] && isBehind(rays, i, k, side * offset[i])) {
                unoccluded[i] = false;
            }
        }
    }

    /** Whether a ray has arrived on the other side of a plane than the light, and clearly not on it. */
    private boolean isBehind(Rays rays, int i, int k, double below) {
        return below > 0 && rays.hit[i] != firstSurface + k && below > offsetError(rays, i, k);
    }

    /** Bounds the error of how far a plane is, along its normal, from where a ray has arrived. */
    private double offsetError(Rays rays, int i, int k) {
        double cosine = rays.dx[i] * nx[k] + rays.dy[i] * ny[k] + rays.dz[i] * nz[k];
        return Rounding.planeOffset(rays.originError[i], products(rays, i, k)) + rays.slide[i] * Math.abs(cosine);
    }

    @Override
    public Kernel moving(Rays rays, Workspace workspace) {
        return (from, to) -> {
            for (int i = from; i < to; i++) {
                int k = rays.hit[i] - firstSurface;
                rays.moveToPlane(i, products(rays, i, k), nx[k], ny[k], nz[k]);
            }
        };
    }
}
