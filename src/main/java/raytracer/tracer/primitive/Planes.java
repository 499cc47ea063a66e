package raytracer.tracer.primitive;

import java.util.List;
import raytracer.scene.Shape;
import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.UnboundedSurfaces;
import raytracer.tracer.surface.Workspace;

/** Infinite planes. */
public final class Planes implements UnboundedSurfaces {

    private final int firstSurface;
    private final Plane[] planes;

    public Planes(List<Shape.Plane> declared, int firstSurface) {
        this.firstSurface = firstSurface;
        planes = new Plane[declared.size()];
        for (int k = 0; k < planes.length; k++) {
            planes[k] = new Plane(declared.get(k), firstSurface + k);
        }
    }

    @Override
    public boolean owns(int surface) {
        return surface >= firstSurface && surface < firstSurface + planes.length;
    }

    @Override
    public void intersect(Rays rays, int from, int to) {
        for (Plane plane : planes) {
            for (int i = from; i < to; i++) {
                double t = plane.distance(rays, i);
                if (t > 0) {
                    rays.record(i, plane.surface(), t);
                }
            }
        }
    }

    @Override
    public void collect(Rays rays, int ray, Candidates candidates, Workspace workspace) {
        for (Plane plane : planes) {
            double t = plane.distance(rays, ray);
            if (t > 0) {
                candidates.add(plane.surface(), t, plane.distanceError(rays, ray, t));
            }
        }
    }

    @Override
    public void block(Rays rays, ShadowRays shadows, int from, int to) {
        for (Plane plane : planes) {
            int side = plane.sideOf(shadows.light);
            for (int i = from; i < to; i++) {
                if (shadows.unoccluded[i] && plane.isBetween(rays, i, side)) {
                    shadows.unoccluded[i] = false;
                }
            }
        }
    }

    @Override
    public boolean anyBlocksAll(Rays rays, ShadowRays shadows, int[] which) {
        for (Plane plane : planes) {
            int side = plane.sideOf(shadows.light);
            int blocked = 0;
            for (int i : which) {
                blocked += plane.isBetween(rays, i, side) ? 1 : 0;
            }
            if (blocked == which.length) {
                return true;
            }
        }
        return false;
    }

    @Override
    public void moveToHits(Rays rays, int from, int to, Workspace workspace) {
        for (int i = from; i < to; i++) {
            planes[rays.hit[i] - firstSurface].moveToHit(rays, i);
        }
    }
}
