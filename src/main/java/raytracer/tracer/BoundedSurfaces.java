package raytracer.tracer;

/** Surfaces of a finite size, many of them: a tree finds the few that a ray may meet. */
abstract sealed class BoundedSurfaces implements Surfaces permits Spheres, Triangles {

    private final int firstSlot;
    private final int count;
    private final Bvh bvh;

    BoundedSurfaces(int firstSlot, Bvh bvh) {
        this.firstSlot = firstSlot;
        this.bvh = bvh;
        count = bvh.order().length;
    }

    /** Offers a ray the surface with this number among these, if it meets it. */
    abstract void meet(Rays rays, int ray, int k);

    /** Whether the surface with this number among these is strictly between a point and its light. */
    abstract boolean blocks(Rays rays, ShadowRays shadows, int ray, int k);

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
            prepareToMeet(rays, 0, rays.count, scratch);
            for (int k = 0; k < bvh.beside(); k++) {
                meetAll(rays, 0, rays.count, k, scratch);
            }
        }
        Beam beam = scratch.beam;
        beam.take(rays, 0, rays.count);
        if (!beam.gather(bvh)) {
            walkToNearest(rays, scratch.walk);
        } else if (beam.count() > 0) {
            prepareToMeet(rays, 0, rays.count, scratch);
            for (int n = 0; n < beam.count(); n++) {
                meetAll(rays, 0, rays.count, beam.thing(n), scratch);
            }
        }
    }

    private void walkToNearest(Rays rays, BvhWalk walk) {
        for (int i = 0; i < rays.count; i++) {
            walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], rays.dx[i], rays.dy[i], rays.dz[i]);
            while (walk.nextLeaf(rays.reach(i))) {
                for (int k = walk.first(); k < walk.end(); k++) {
                    meet(rays, i, k);
                }
            }
        }
    }

    @Override
    public final void block(Rays rays, ShadowRays shadows, int from, int to, Scratch scratch) {
        if (bvh.beside() > 0) {
            prepareToBlock(rays, shadows, from, to, scratch);
            for (int k = 0; k < bvh.beside(); k++) {
                blockAll(rays, shadows, from, to, k, scratch);
            }
        }
        Beam beam = scratch.beam;
        beam.take(rays, shadows.lamp, from, to);
        if (!beam.gather(bvh)) {
            walkToBlockers(rays, shadows, from, to, scratch.walk);
        } else if (beam.count() > 0) {
            prepareToBlock(rays, shadows, from, to, scratch);
            for (int n = 0; n < beam.count(); n++) {
                blockAll(rays, shadows, from, to, beam.thing(n), scratch);
            }
        }
    }

    private void walkToBlockers(Rays rays, ShadowRays shadows, int from, int to, BvhWalk walk) {
        for (int i = from; i < to; i++) {
            if (shadows.open[i]) {
                walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], shadows.dx[i], shadows.dy[i], shadows.dz[i]);
                shadows.open[i] = !anyBlocks(rays, shadows, i, walk);
            }
        }
    }

    private boolean anyBlocks(Rays rays, ShadowRays shadows, int ray, BvhWalk walk) {
        while (walk.nextLeaf(shadows.distance[ray])) {
            for (int k = walk.first(); k < walk.end(); k++) {
                if (blocks(rays, shadows, ray, k)) {
                    return true;
                }
            }
        }
        return false;
    }
}
