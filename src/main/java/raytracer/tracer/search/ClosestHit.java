package raytracer.tracer.search;

import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Surfaces;

/** Records the closest hit of each of a batch's rays with surfaces of one kind. */
public final class ClosestHit extends TreeSearch {

    /** The search among surfaces of one kind; where no tree has any, it only tries each. */
    public static Search among(Surfaces kind, Rays rays, SearchWorkspace space) {
        ClosestHit search = new ClosestHit(kind, rays, space);
        return kind.bvh().root() == Bvh.EMPTY ? search::tryOversized : search;
    }

    private ClosestHit(Surfaces surfaces, Rays rays, SearchWorkspace space) {
        super(surfaces, rays, rays.direction, rays.originError, rays.directionError, space);
    }

    @Override
    void enclose(int from, int to) {
        space.intervals().enclose(rays, from, to);
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
}
