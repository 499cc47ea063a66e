package raytracer.tracer.search;

import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/**
 * Occludes the shadow rays that surfaces of one kind block. Before it walks the tree, a ray tries the surface that last
 * blocked another: neighbours are mostly in the same shadow (a shadow cache).
 */
public final class AnyHit extends TreeSearch {

    private final ShadowRays shadows;

    /** The surface that last blocked a ray; negative if none has. */
    private int lastBlocker = -1;

    /** The search among surfaces of one kind; where no tree has any, it only tries each. */
    public static Search among(Surfaces kind, Rays rays, ShadowRays shadows, Workspace workspace) {
        AnyHit search = new AnyHit(kind, rays, shadows, workspace);
        return kind.bvh().root() == Bvh.EMPTY ? search::tryOversized : search;
    }

    private AnyHit(Surfaces surfaces, Rays rays, ShadowRays shadows, Workspace workspace) {
        super(surfaces, rays, shadows.direction, shadows.originError, shadows.directionError, workspace);
        this.shadows = shadows;
    }

    @Override
    void enclose(int from, int to) {
        intervals.enclose(rays, shadows.light, from, to);
    }

    @Override
    void prepare(int from, int to) {
        surfaces.prepareToBlock(rays, shadows, from, to, workspace);
    }

    @Override
    void tryAll(int from, int to, int k) {
        surfaces.blockAll(rays, shadows, from, to, k, workspace);
    }

    @Override
    boolean tryLikely(int ray) {
        return !shadows.unoccluded[ray] || lastBlocker >= 0 && tryOne(ray, lastBlocker);
    }

    @Override
    double maxDistance(int ray) {
        return shadows.distance[ray];
    }

    @Override
    boolean tryOne(int ray, int k) {
        if (!surfaces.blocks(rays, shadows, ray, k)) {
            return false;
        }
        shadows.unoccluded[ray] = false;
        lastBlocker = k;
        return true;
    }
}
