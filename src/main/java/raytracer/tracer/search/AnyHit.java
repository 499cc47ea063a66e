package raytracer.tracer.search;

import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.lightbuffer.LazyLightBuffer;
import raytracer.tracer.lightbuffer.LightBuffer;
import raytracer.tracer.primitive.BoundedSurfaces;
import raytracer.tracer.primitive.Planes;
import raytracer.tracer.primitive.Surfaces;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;

/**
 * Occludes the shadow rays that surfaces of one kind block. If the rays' {@link Beam} finds few surfaces, all rays try
 * those; else each looks up what may be in its way in a {@link LightBuffer}, once there is one, or walks the tree. For
 * one thread.
 */
public final class AnyHit implements Kernel {

    private final BoundedSurfaces surfaces;
    private final Bvh bvh;
    private final Rays rays;
    private final ShadowRays shadows;
    private final SearchWorkspace space;

    private final Kernel blockOversized = this::blockOversized;
    private final Kernel blockGathered = this::blockGathered;
    private final Kernel walk = this::walk;
    private final Kernel findCells = this::findCells;
    private final Kernel lookUp = this::lookUp;

    /** Where rays are looked up, if they are. */
    private LightBuffer buffer;

    /** What occludes every shadow ray that a surface of one kind blocks between its ends. */
    public static Kernel among(Surfaces kind, Rays rays, ShadowRays shadows, SearchWorkspace space) {
        return kind instanceof BoundedSurfaces bounded
                ? new AnyHit(bounded, rays, shadows, space)
                : ((Planes) kind).blocking(rays, shadows, space.surfaces());
    }

    private AnyHit(BoundedSurfaces surfaces, Rays rays, ShadowRays shadows, SearchWorkspace space) {
        this.surfaces = surfaces;
        this.rays = rays;
        this.shadows = shadows;
        this.space = space;
        bvh = surfaces.bvh();
    }

    @Override
    public void run(int from, int to) {
        if (bvh.oversized() > 0) {
            Kernel.run(blockOversized, from, to);
        }
        LazyLightBuffer lazy = surfaces.lightBuffer(shadows.light);
        // What mirrors show is too scattered for a beam, nearly always.
        if (!rays.leaveEye && lazy != null && lookUp(lazy.ifBuilt(), from, to)) {
            return;
        }
        space.beam().enclose(rays, shadows.light, from, to);
        if (!space.beam().gather(bvh)) {
            blockEach(lazy, from, to);
        } else if (space.beam().count() > 0) {
            Kernel.run(blockGathered, from, to);
        }
    }

    private void blockOversized(int from, int to) {
        surfaces.prepareToBlock(rays, shadows, from, to, space.surfaces());
        for (int k = 0; k < bvh.oversized(); k++) {
            surfaces.blockAll(rays, shadows, from, to, k, space.surfaces());
        }
    }

    private void blockGathered(int from, int to) {
        surfaces.prepareToBlock(rays, shadows, from, to, space.surfaces());
        for (int n = 0; n < space.beam().count(); n++) {
            surfaces.blockAll(rays, shadows, from, to, space.beam().primitive(n), space.surfaces());
        }
    }

    /** Ray by ray, after the beam of all has given up. */
    private void blockEach(LazyLightBuffer lazy, int from, int to) {
        if (lazy != null && lookUp(lazy.insteadOfWalks(to - from), from, to)) {
            return;
        }
        Kernel.run(walk, from, to);
    }

    /** Looks rays up in a light buffer; false if there is none, or they start too far away. */
    private boolean lookUp(LightBuffer in, int from, int to) {
        if (in == null || !in.isNearEnough(rays, from, to)) {
            return false;
        }
        buffer = in;
        Kernel.run(findCells, from, to);
        Kernel.run(lookUp, from, to);
        return true;
    }

    private void walk(int from, int to) {
        for (int i = from; i < to; i++) {
            if (shadows.unoccluded[i]) {
                walk(i);
            }
        }
    }

    private void walk(int i) {
        BvhWalk walk = space.surfaces().walk;
        if (walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], shadows.dx[i], shadows.dy[i], shadows.dz[i])) {
            look(walk.x(), walk.y(), walk.z(), walk.start(), i);
            shadows.unoccluded[i] = !anyOnTheWayBlocks(i);
        }
    }

    private void look(double x, double y, double z, double far, int i) {
        surfaces.look(bvh, x, y, z, far, shadows.dx[i], shadows.dy[i], shadows.dz[i], shadows.originError[i],
                2 * Rounding.U, space.surfaces());
    }

    private boolean anyOnTheWayBlocks(int ray) {
        BvhWalk walk = space.surfaces().walk;
        while (walk.nextLeaf(shadows.distance[ray])) {
            for (int left = surfaces.inSight(walk.first(), walk.end(), space.surfaces()); left != 0; left &= left - 1) {
                if (surfaces.blocks(rays, shadows, ray, walk.first() + Integer.numberOfTrailingZeros(left))) {
                    return true;
                }
            }
        }
        return false;
    }

    private void findCells(int from, int to) {
        buffer.find(rays, from, to, space.cells());
    }

    private void lookUp(int from, int to) {
        LightBuffer.Cells cells = space.cells();
        for (int i = from; i < to; i++) {
            if (shadows.unoccluded[i] && cells.first[i] < cells.end[i]) {
                double x = cells.x[i], y = cells.y[i], z = cells.z[i];
                look(x, y, z, Math.abs(x) + Math.abs(y) + Math.abs(z), i);
                shadows.unoccluded[i] = !anyInTheCellBlocks(i);
            }
        }
    }

    private boolean anyInTheCellBlocks(int ray) {
        LightBuffer.Cells cells = space.cells();
        for (int entry = cells.first[ray]; entry < cells.end[ray] && buffer.isNearer(entry, ray, cells); entry++) {
            int k = buffer.primitive(entry);
            if (surfaces.inSight(k, k + 1, space.surfaces()) != 0 && surfaces.blocks(rays, shadows, ray, k)) {
                return true;
            }
        }
        return false;
    }
}
