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
    public Kernel intersecting(Rays rays) {
        return (from, to) -> findClosestHits(rays, from, to);
    }

    private void findClosestHits(Rays rays, int from, int to) {
        for (int k = 0; k < count; k++) {
            for (int i = from; i < to; i++) {
                double t = distance(rays, i, k);
                if (t > 0) {
                    rays.record(i, firstSurface + k, t);
                }
            }
        }
    }

    /** The distance at which a ray hits a plane; NaN if it does not. */
    private double distance(Rays rays, int i, int k) {
        double offset = offset(rays, i, k), cosine = cosine(rays, i, k), t = offset / cosine;
        boolean isHit = t > 0 && t <= rays.maxDistance(i) && Math.abs(cosine) > Rounding.cosine(rays.directionError[i])
                && rays.source[i] != firstSurface + k && Math.abs(offset) > offsetError(rays, i, k);
        return isHit ? t : Double.NaN;
    }

    /** (p - o) . n */
    private double offset(Rays rays, int i, int k) {
        return (px[k] - rays.ox[i]) * nx[k] + (py[k] - rays.oy[i]) * ny[k] + (pz[k] - rays.oz[i]) * nz[k];
    }

    /** d . n */
    private double cosine(Rays rays, int i, int k) {
        return rays.dx[i] * nx[k] + rays.dy[i] * ny[k] + rays.dz[i] * nz[k];
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
            double t = distance(rays, i, k);
            if (t > 0) {
                candidates.add(firstSurface + k, t, Rounding.planeDistance(rays.originError[i], rays.directionError[i],
                        products(rays, i, k), t, cosine(rays, i, k)));
            }
        }
    }

    @Override
    public Kernel blocking(Rays rays, ShadowRays shadows) {
        return (from, to) -> block(rays, shadows, from, to);
    }

    @Override
    public boolean anyBlocksAll(Rays rays, ShadowRays shadows, int[] which) {
        for (int k = 0; k < count; k++) {
            int side = sideOfLight(shadows.light, k);
            int blocked = 0;
            for (int i : which) {
                blocked += isBehind(rays, i, k, side * offset(rays, i, k)) ? 1 : 0;
            }
            if (blocked == which.length) {
                return true;
            }
        }
        return false;
    }

    private void block(Rays rays, ShadowRays shadows, int from, int to) {
        for (int k = 0; k < count; k++) {
            int side = sideOfLight(shadows.light, k);
            if (side != 0) {
                occlude(rays, shadows.unoccluded, k, side, from, to);
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
    private void occlude(Rays rays, boolean[] unoccluded, int k, int side, int from, int to) {
        for (int i = from; i < to; i++) {
            if (unoccluded[i] && isBehind(rays, i, k, side * offset(rays, i, k))) {
                unoccluded[i] = false;
            }
        }
    }

    /** Whether a ray has arrived on the other side of a plane than the light, and clearly not on it. */
    private boolean isBehind(Rays rays, int i, int k, double below) {
        return below > 0 && rays.hit[i] != firstSurface + k && below > offsetError(rays, i, k);
    }

    /** Bounds the error of how far a plane is, along its normal, from where a ray starts or has arrived. */
    private double offsetError(Rays rays, int i, int k) {
        return Rounding.planeOffset(rays.originError[i], products(rays, i, k))
                + rays.slide[i] * Math.abs(cosine(rays, i, k));
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
