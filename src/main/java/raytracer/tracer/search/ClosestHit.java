package raytracer.tracer.search;

import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** Records the closest hit of each of a batch's rays with surfaces of one kind. */
public final class ClosestHit extends TreeSearch {

    /** The search among surfaces of one kind; where no tree has any, it only tries each. */
    public static Search among(Surfaces kind, Rays rays, Workspace workspace) {
        ClosestHit search = new ClosestHit(kind, rays, workspace);
        return kind.bvh().root() == Bvh.EMPTY ? search::tryOversized : search;
    }

    private ClosestHit(Surfaces surfaces, Rays rays, Workspace workspace) {
        super(surfaces, rays, rays.direction, rays.originError, rays.directionError, workspace);
    }

    @Override
    void enclose(int from, int to) {
        intervals.enclose(rays, from, to);
    }

    @Override
    void prepare(int from, int to) {
        surfaces.prepareToIntersect(rays, from, to, workspace);
    }

    @Override
    void tryAll(int from, int to, int k) {
        surfaces.intersectAll(rays, from, to, k, workspace);
    }

    @Override
    boolean tryLikely(int ray) {
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
