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

    /** Where rays are looked up, if they are. */
    private LightBuffer buffer;

    private final Kernel findCells = this::findCells;
    private final Kernel lookUp = this::lookUp;

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

    /** Each ray looks up what may be in its way, if there is a light buffer to look into, or walks the tree. */
    @Override
    void searchEach(int from, int to) {
        LazyLightBuffer lazy = surfaces.lightBuffer(shadows.light);
        LightBuffer built = lazy == null ? null : lazy.insteadOfWalks(to - from);
        if (built != null && built.isNearEnough(rays, from, to)) {
            lookUp(built, from, to);
        } else {
            super.searchEach(from, to);
        }
    }

    private void lookUp(LightBuffer in, int from, int to) {
        buffer = in;
        Kernel.run(findCells, from, to);
        Kernel.run(lookUp, from, to);
    }

    private void findCells(int from, int to) {
        buffer.find(rays, from, to, space.cells());
    }

    private void lookUp(int from, int to) {
        LightBuffer.Cells cells = space.cells();
        for (int i = from; i < to; i++) {
            if (cells.first[i] < cells.end[i] && isSearching(i)) {
                double x = cells.x[i], y = cells.y[i], z = cells.z[i];
                setLine(x, y, z, Math.abs(x) + Math.abs(y) + Math.abs(z), i);
                tryCell(i, cells);
            }
        }
    }

    private void tryCell(int ray, LightBuffer.Cells cells) {
        for (int entry = cells.first[ray]; entry < cells.end[ray] && buffer.isNearer(entry, ray, cells); entry++) {
            int k = buffer.primitive(entry);
            if (surfaces.mayHit(k, k + 1, space.surfaces()) != 0 && isLast(ray, k)) {
                return;
            }
        }
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
}
