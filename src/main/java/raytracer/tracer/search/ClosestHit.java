package raytracer.tracer.search;

import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.surface.SieveLine;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.UnboundedSurfaces;

/** Records the closest hit of each of a batch's rays with surfaces of one kind. */
public final class ClosestHit extends TreeSearch {

    public static Search among(Surfaces kind, Rays rays, SearchWorkspace space) {
        return kind instanceof BoundedSurfaces bounded
                ? new ClosestHit(bounded, rays, space)
                : (from, to) -> ((UnboundedSurfaces) kind).intersect(rays, from, to);
    }

    private ClosestHit(BoundedSurfaces surfaces, Rays rays, SearchWorkspace space) {
        super(surfaces, rays, rays.direction, space);
    }

    @Override
    void encloseInBeam(int from, int to) {
        space.beam().enclose(rays, from, to);
    }

    @Override
    void prepare(int from, int to) {
        surfaces.prepareToIntersect(rays, from, to, space.surfaces());
    }

    @Override
    void tryAll(int from, int to, int k) {
        surfaces.intersectAll(rays, from, to, k, space.surfaces());
    }

    @Override
    boolean isDone(int ray) {
        return false;
    }

    @Override
    double maxDistance(int ray) {
        return rays.maxDistance(ray);
    }

    @Override
    boolean tryOne(int ray, int k) {
        surfaces.intersect(rays, ray, k);
        return false;
    }

    @Override
    void setDirection(SieveLine line, int i) {
        line.setDirection(rays.dx[i], rays.dy[i], rays.dz[i], rays.originError[i] * bvh.space().scale(),
                rays.directionError[i]);
    }
}
