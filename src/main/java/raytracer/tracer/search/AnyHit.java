package raytracer.tracer.search;

import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.lightbuffer.LazyLightBuffer;
import raytracer.tracer.lightbuffer.LightBuffer;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.surface.SieveLine;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.UnboundedSurfaces;

/** Occludes the shadow rays that surfaces of one kind block. */
public final class AnyHit extends Search {

    private final ShadowRays shadows;

    /** What occludes every shadow ray that a surface of one kind blocks between its ends. */
    public static Kernel among(Surfaces kind, Rays rays, ShadowRays shadows, SearchWorkspace space) {
        return kind instanceof BoundedSurfaces bounded
                ? new AnyHit(bounded, rays, shadows, space)
                : ((UnboundedSurfaces) kind).blocking(rays, shadows, space.surfaces());
    }

    private AnyHit(BoundedSurfaces surfaces, Rays rays, ShadowRays shadows, SearchWorkspace space) {
        super(surfaces, rays, shadows.direction, space);
        this.shadows = shadows;
    }

    /** What mirrors show is too scattered for a beam, nearly always. */
    @Override
    boolean isDoneWithoutBeam(int from, int to) {
        LazyLightBuffer lazy = rays.leaveEye ? null : surfaces.lightBuffer(shadows.light);
        LightBuffer built = lazy == null ? null : lazy.ifBuilt();
        if (built == null || !built.isNearEnough(rays, from, to)) {
            return false;
        }
        lookUp(built, from, to);
        return true;
    }

    @Override
    void encloseInBeam(int from, int to) {
        space.beam().enclose(rays, shadows.light, from, to);
    }

    @Override
    LightBuffer bufferInsteadOfWalks(int from, int to) {
        LazyLightBuffer lazy = surfaces.lightBuffer(shadows.light);
        LightBuffer built = lazy == null ? null : lazy.insteadOfWalks(to - from);
        return built != null && built.isNearEnough(rays, from, to) ? built : null;
    }

    @Override
    void prepare(int from, int to) {
        surfaces.prepareToBlock(rays, shadows, from, to, space.surfaces());
    }

    @Override
    void tryAll(int from, int to, int k) {
        surfaces.blockAll(rays, shadows, from, to, k, space.surfaces());
    }

    @Override
    boolean isSearching(int ray) {
        return shadows.unoccluded[ray];
    }

    @Override
    double maxDistance(int ray) {
        return shadows.distance[ray];
    }

    @Override
    boolean isLast(int ray, int k) {
        boolean blocked = surfaces.blocks(rays, shadows, ray, k);
        shadows.unoccluded[ray] = !blocked;
        return blocked;
    }

    @Override
    void setDirection(SieveLine line, int i) {
        line.setDirection(shadows.dx[i], shadows.dy[i], shadows.dz[i], shadows.originError[i] * bvh.space().scale(),
                2 * Rounding.U);
    }

    @Override
    void findCells(int from, int to) {
        buffer.find(rays, from, to, space.cells());
    }

    @Override
    void shortenCell(int ray) { }
}
