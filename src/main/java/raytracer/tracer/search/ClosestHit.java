package raytracer.tracer.search;

import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.lightbuffer.LazyLightBuffer;
import raytracer.tracer.lightbuffer.LightBuffer;
import raytracer.tracer.primitive.BoundedSurfaces;
import raytracer.tracer.primitive.Planes;
import raytracer.tracer.primitive.Surfaces;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;

/**
 * Records the closest hit of each of a batch's rays with surfaces of one kind. If the rays' {@link Beam} finds few, all
 * rays try those; else a ray from the eye looks up what is ahead of it in the eye's {@link LightBuffer}, once there is
 * one, and any other walks the tree. For one thread.
 */
public final class ClosestHit implements Kernel {

    private final BoundedSurfaces surfaces;
    private final Bvh bvh;
    private final Rays rays;
    private final SearchWorkspace space;

    private final Kernel intersectOversized = this::intersectOversized;
    private final Kernel intersectGathered = this::intersectGathered;
    private final Kernel walk = this::walk;
    private final Kernel findCells = this::findCells;
    private final Kernel lookUp = this::lookUp;

    private final LazyLightBuffer ofEye;
    private LightBuffer buffer;

    /**
     * What records for every ray the nearest surface of one kind that it hits.
     *
     * @param eye where rays start, if they leave the eye
     */
    public static Kernel among(Surfaces kind, Rays rays, LightSource eye, SearchWorkspace space) {
        return kind instanceof BoundedSurfaces bounded
                ? new ClosestHit(bounded, rays, bounded.lightBuffer(eye), space)
                : ((Planes) kind).intersecting(rays, space.surfaces());
    }

    /** @param ofEye null if there is none, nor will be */
    private ClosestHit(BoundedSurfaces surfaces, Rays rays, LazyLightBuffer ofEye, SearchWorkspace space) {
        this.surfaces = surfaces;
        this.rays = rays;
        this.ofEye = ofEye;
        this.space = space;
        bvh = surfaces.bvh();
    }

    @Override
    public void run(int from, int to) {
        if (bvh.oversized() > 0) {
            Kernel.run(intersectOversized, from, to);
        }
        space.beam().enclose(rays, from, to);
        if (!space.beam().gather(bvh)) {
            findEach(from, to);
        } else if (space.beam().count() > 0) {
            Kernel.run(intersectGathered, from, to);
        }
    }

    private void intersectOversized(int from, int to) {
        surfaces.prepareToIntersect(rays, from, to, space.surfaces());
        for (int k = 0; k < bvh.oversized(); k++) {
            surfaces.intersectAll(rays, from, to, k, space.surfaces());
        }
    }

    private void intersectGathered(int from, int to) {
        surfaces.prepareToIntersect(rays, from, to, space.surfaces());
        for (int n = 0; n < space.beam().count(); n++) {
            surfaces.intersectAll(rays, from, to, space.beam().primitive(n), space.surfaces());
        }
    }

    /** Ray by ray, after the beam of all has given up. */
    private void findEach(int from, int to) {
        buffer = rays.leaveEye && ofEye != null ? ofEye.insteadOfWalks(to - from) : null;
        if (buffer != null) {
            Kernel.run(findCells, from, to);
            Kernel.run(lookUp, from, to);
        } else {
            Kernel.run(walk, from, to);
        }
    }

    // What one ray does is a method of its own: HotSpot compiles it long before a loop over rays of which few do it.

    private void walk(int from, int to) {
        for (int i = from; i < to; i++) {
            walk(i);
        }
    }

    private void walk(int i) {
        BvhWalk walk = space.surfaces().walk;
        if (walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], rays.dx[i], rays.dy[i], rays.dz[i])) {
            look(walk.x(), walk.y(), walk.z(), walk.start(), i);
            intersectOnTheWay(i);
        }
    }

    private void look(double x, double y, double z, double far, int i) {
        surfaces.look(bvh, x, y, z, far, rays.dx[i], rays.dy[i], rays.dz[i], rays.originError[i],
                rays.directionError[i], space.surfaces());
    }

    private void intersectOnTheWay(int ray) {
        BvhWalk walk = space.surfaces().walk;
        while (walk.nextLeaf(rays.maxDistance(ray))) {
            for (int left = surfaces.inSight(walk.first(), walk.end(), space.surfaces()); left != 0; left &= left - 1) {
                surfaces.intersect(rays, ray, walk.first() + Integer.numberOfTrailingZeros(left));
            }
        }
    }

    private void findCells(int from, int to) {
        buffer.findAhead(rays, from, to, space.cells());
    }

    private void lookUp(int from, int to) {
        LightBuffer.Cells cells = space.cells();
        for (int i = from; i < to; i++) {
            if (cells.first[i] < cells.end[i]) {
                double x = cells.x[i], y = cells.y[i], z = cells.z[i];
                look(x, y, z, Math.abs(x) + Math.abs(y) + Math.abs(z), i);
                intersectInTheCell(i);
            }
        }
    }

    private void intersectInTheCell(int ray) {
        LightBuffer.Cells cells = space.cells();
        for (int entry = cells.first[ray]; entry < cells.end[ray] && buffer.isNearer(entry, ray, cells); entry++) {
            int k = buffer.primitive(entry);
            if (surfaces.inSight(k, k + 1, space.surfaces()) != 0) {
                surfaces.intersect(rays, ray, k);
                buffer.limit(rays.maxDistance(ray), ray, cells);
            }
        }
    }
}
