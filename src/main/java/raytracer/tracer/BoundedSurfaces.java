package raytracer.tracer;

import java.util.List;
import java.util.Map;

/** Surfaces of a finite size, many of them: a tree finds the few that a ray may meet. */
abstract sealed class BoundedSurfaces implements Surfaces permits Spheres, Triangles {

    private final int firstSlot;
    private final int count;
    private final Bvh bvh;
    private final Map<Lamp, LazyLightBuffer> lightBuffers;

    /** @param hulls by number among these */
    BoundedSurfaces(int firstSlot, Bvh bvh, Hulls hulls, List<Lamp> lamps) {
        this.firstSlot = firstSlot;
        this.bvh = bvh;
        count = bvh.order().length;
        lightBuffers = LazyLightBuffer.of(lamps, bvh, hulls);
    }

    /** Offers a ray the surface with this number among these, if it meets it. */
    abstract void meet(Rays rays, int ray, int k);

    /** Whether the surface with this number among these is strictly between a point and its light. */
    abstract boolean blocks(Rays rays, ShadowRays shadows, int ray, int k);

    /**
     * Looks along a ray through (x, y, z) in the tree's space, for {@link #inSight}.
     *
     * @param far no point of the tree's cube is farther from the ray's origin than this plus 4
     */
    abstract void look(Bvh tree, double x, double y, double z, double far, double dx, double dy, double dz,
            double originError, double directionError, Scratch scratch);

    /**
     * Which of some surfaces, no more than a leaf has, the ray in {@link #look} may meet, at a glance: a bit for each,
     * the first one's lowest. No branch depends on what is seen, for the processor would often guess it wrong.
     */
    abstract int inSight(int first, int end, Scratch scratch);

    final TreeFacts facts() {
        return TreeFacts.of(this instanceof Spheres ? "spheres" : "triangles", bvh);
    }

    final int slot(int k) {
        return firstSlot + k;
    }

    final int number(int slot) {
        return slot - firstSlot;
    }

    @Override
    public final boolean owns(int slot) {
        return slot >= firstSlot && slot < firstSlot + count;
    }

    /** Computes what {@link #meetAll} needs to know of rays, from one index to another. */
    abstract void prepareToMeet(Rays rays, int from, int to, Scratch scratch);

    /** Computes what {@link #blockAll} needs to know of shadow rays, from one index to another. */
    abstract void prepareToBlock(Rays rays, ShadowRays shadows, int from, int to, Scratch scratch);

    /** Offers rays, from one index to another, the surface with this number among these, if it meets it. */
    abstract void meetAll(Rays rays, int from, int to, int k, Scratch scratch);

    /** Closes every open shadow ray from one index to another that the surface with this number among these blocks. */
    abstract void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Scratch scratch);

    @Override
    public final void findNearest(Rays rays, Scratch scratch) {
        if (bvh.beside() > 0) {
            Pass.run((from, to) -> meetBeside(rays, from, to, scratch), 0, rays.count);
        }
        Beam beam = scratch.beam;
        beam.take(rays, 0, rays.count);
        if (!beam.gather(bvh)) {
            Pass.run((from, to) -> scratch.entryPoints.find(bvh, beam, rays.origin, rays.direction, from, to),
                    0, rays.count);
            Pass.run((from, to) -> walkToNearest(rays, from, to, scratch), 0, rays.count);
        } else if (beam.count() > 0) {
            Pass.run((from, to) -> meetThings(rays, from, to, scratch), 0, rays.count);
        }
    }

    private void meetBeside(Rays rays, int from, int to, Scratch scratch) {
        prepareToMeet(rays, from, to, scratch);
        for (int k = 0; k < bvh.beside(); k++) {
            meetAll(rays, from, to, k, scratch);
        }
    }

    private void meetThings(Rays rays, int from, int to, Scratch scratch) {
        prepareToMeet(rays, from, to, scratch);
        for (int n = 0; n < scratch.beam.count(); n++) {
            meetAll(rays, from, to, scratch.beam.thing(n), scratch);
        }
    }

    // A walk is a method of its own, which HotSpot compiles long before a loop over rays in which few of them walk.

    private void walkToNearest(Rays rays, int from, int to, Scratch scratch) {
        for (int i = from; i < to; i++) {
            if (scratch.entryPoints.leadIn(i)) {
                walkToNearest(rays, i, scratch);
            }
        }
    }

    private void walkToNearest(Rays rays, int i, Scratch scratch) {
        BvhWalk walk = scratch.walk;
        if (walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], rays.dx[i], rays.dy[i], rays.dz[i])) {
            scratch.entryPoints.enter(walk, i);
            look(bvh, walk.x(), walk.y(), walk.z(), walk.start(),
                    rays.dx[i], rays.dy[i], rays.dz[i], rays.originError[i], rays.directionError[i], scratch);
            meetOnTheWay(rays, i, scratch);
        }
    }

    private void meetOnTheWay(Rays rays, int ray, Scratch scratch) {
        BvhWalk walk = scratch.walk;
        while (walk.nextLeaf(rays.reach(ray))) {
            for (int left = inSight(walk.first(), walk.end(), scratch); left != 0; left &= left - 1) {
                meet(rays, ray, walk.first() + Integer.numberOfTrailingZeros(left));
            }
        }
    }

    @Override
    public final Pass blocking(Rays rays, ShadowRays shadows, Scratch scratch) {
        return (from, to) -> block(rays, shadows, from, to, scratch);
    }

    private void block(Rays rays, ShadowRays shadows, int first, int end, Scratch scratch) {
        if (bvh.beside() > 0) {
            Pass.run((from, to) -> blockBeside(rays, shadows, from, to, scratch), first, end);
        }
        LazyLightBuffer lazy = lightBuffers.get(shadows.lamp);
        // What mirrors show is too scattered for a beam, nearly always.
        if (!rays.leaveEye && lazy != null && lookUp(lazy.ifBuilt(), rays, shadows, first, end, scratch)) {
            return;
        }
        Beam beam = scratch.beam;
        beam.take(rays, shadows.lamp, first, end);
        if (!beam.gather(bvh)) {
            blockEach(lazy, rays, shadows, first, end, scratch);
        } else if (beam.count() > 0) {
            Pass.run((from, to) -> blockThings(rays, shadows, from, to, scratch), first, end);
        }
    }

    /** Ray by ray, after the beam of all has given up. */
    private void blockEach(
            LazyLightBuffer lazy, Rays rays, ShadowRays shadows, int first, int end, Scratch scratch) {
        if (lazy != null && lookUp(lazy.insteadOfWalks(end - first), rays, shadows, first, end, scratch)) {
            return;
        }
        Pass.run((from, to) -> scratch.entryPoints.find(
                bvh, scratch.beam, rays.origin, shadows.direction, from, to), first, end);
        Pass.run((from, to) -> walkToBlockers(rays, shadows, from, to, scratch), first, end);
    }

    /** Looks rays up in a light buffer; false if there is none, or they start too far away. */
    private boolean lookUp(
            LightBuffer buffer, Rays rays, ShadowRays shadows, int first, int end, Scratch scratch) {
        if (buffer == null || !buffer.reaches(rays, first, end)) {
            return false;
        }
        Pass.run((from, to) -> buffer.find(rays, from, to, scratch.cells), first, end);
        Pass.run((from, to) -> lookUpBlockers(buffer, rays, shadows, from, to, scratch), first, end);
        return true;
    }

    private void blockBeside(Rays rays, ShadowRays shadows, int from, int to, Scratch scratch) {
        prepareToBlock(rays, shadows, from, to, scratch);
        for (int k = 0; k < bvh.beside(); k++) {
            blockAll(rays, shadows, from, to, k, scratch);
        }
    }

    private void blockThings(Rays rays, ShadowRays shadows, int from, int to, Scratch scratch) {
        prepareToBlock(rays, shadows, from, to, scratch);
        for (int n = 0; n < scratch.beam.count(); n++) {
            blockAll(rays, shadows, from, to, scratch.beam.thing(n), scratch);
        }
    }

    private void walkToBlockers(Rays rays, ShadowRays shadows, int from, int to, Scratch scratch) {
        for (int i = from; i < to; i++) {
            if (shadows.open[i] && scratch.entryPoints.leadIn(i)) {
                walkToBlocker(rays, shadows, i, scratch);
            }
        }
    }

    private void walkToBlocker(Rays rays, ShadowRays shadows, int i, Scratch scratch) {
        BvhWalk walk = scratch.walk;
        if (walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], shadows.dx[i], shadows.dy[i], shadows.dz[i])) {
            scratch.entryPoints.enter(walk, i);
            look(bvh, walk.x(), walk.y(), walk.z(), walk.start(),
                    shadows.dx[i], shadows.dy[i], shadows.dz[i], rays.originError[i], 2 * Rounding.U, scratch);
            shadows.open[i] = !anyBlocks(rays, shadows, i, scratch);
        }
    }

    private boolean anyBlocks(Rays rays, ShadowRays shadows, int ray, Scratch scratch) {
        BvhWalk walk = scratch.walk;
        while (walk.nextLeaf(shadows.distance[ray])) {
            for (int left = inSight(walk.first(), walk.end(), scratch); left != 0; left &= left - 1) {
                if (blocks(rays, shadows, ray, walk.first() + Integer.numberOfTrailingZeros(left))) {
                    return true;
                }
            }
        }
        return false;
    }

    private void lookUpBlockers(LightBuffer buffer, Rays rays, ShadowRays shadows, int from, int to, Scratch scratch) {
        LightBuffer.Cells cells = scratch.cells;
        for (int i = from; i < to; i++) {
            if (shadows.open[i] && cells.first[i] < cells.end[i]) {
                double x = cells.x[i], y = cells.y[i], z = cells.z[i];
                look(bvh, x, y, z, Math.abs(x) + Math.abs(y) + Math.abs(z),
                        shadows.dx[i], shadows.dy[i], shadows.dz[i], rays.originError[i], 2 * Rounding.U, scratch);
                shadows.open[i] = !anyBlocks(buffer, rays, shadows, i, scratch);
            }
        }
    }

    private boolean anyBlocks(LightBuffer buffer, Rays rays, ShadowRays shadows, int ray, Scratch scratch) {
        LightBuffer.Cells cells = scratch.cells;
        for (int entry = cells.first[ray]; entry < cells.end[ray] && buffer.isNearer(entry, ray, cells); entry++) {
            int k = buffer.thing(entry);
            if (inSight(k, k + 1, scratch) != 0 && blocks(rays, shadows, ray, k)) {
                return true;
            }
        }
        return false;
    }
}
