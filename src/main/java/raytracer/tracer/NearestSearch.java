package raytracer.tracer;

/**
 * Offers a tile's rays the surfaces of one kind that they meet: to all rays those that their {@link Beam} meets, if it
 * finds few; else each ray walks through the tree. For one thread.
 */
final class NearestSearch implements Pass {

    private final BoundedSurfaces surfaces;
    private final Bvh bvh;
    private final Rays rays;
    private final Scratch scratch;

    private final Pass meetBeside = this::meetBeside;
    private final Pass meetGathered = this::meetGathered;
    private final Pass findEntryPoints = this::findEntryPoints;
    private final Pass walk = this::walk;

    NearestSearch(BoundedSurfaces surfaces, Rays rays, Scratch scratch) {
        this.surfaces = surfaces;
        this.rays = rays;
        this.scratch = scratch;
        bvh = surfaces.bvh();
    }

    @Override
    public void run(int from, int to) {
        if (bvh.beside() > 0) {
            Pass.run(meetBeside, from, to);
        }
        scratch.beam.take(rays, from, to);
        if (!scratch.beam.gather(bvh)) {
            Pass.run(findEntryPoints, from, to);
            Pass.run(walk, from, to);
        } else if (scratch.beam.count() > 0) {
            Pass.run(meetGathered, from, to);
        }
    }

    private void meetBeside(int from, int to) {
        surfaces.prepareToMeet(rays, from, to, scratch);
        for (int k = 0; k < bvh.beside(); k++) {
            surfaces.meetAll(rays, from, to, k, scratch);
        }
    }

    private void meetGathered(int from, int to) {
        surfaces.prepareToMeet(rays, from, to, scratch);
        for (int n = 0; n < scratch.beam.count(); n++) {
            surfaces.meetAll(rays, from, to, scratch.beam.thing(n), scratch);
        }
    }

    private void findEntryPoints(int from, int to) {
        scratch.entryPoints.find(bvh, scratch.beam, rays.origin, rays.direction, from, to);
    }

    // A ray's walk is a method of its own, which HotSpot compiles long before a loop over rays in which few of them walk.

    private void walk(int from, int to) {
        for (int i = from; i < to; i++) {
            if (scratch.entryPoints.leadIn(i)) {
                walk(i);
            }
        }
    }

    private void walk(int i) {
        BvhWalk walk = scratch.walk;
        if (walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], rays.dx[i], rays.dy[i], rays.dz[i])) {
            scratch.entryPoints.enter(walk, i);
            surfaces.look(bvh, walk.x(), walk.y(), walk.z(), walk.start(),
                    rays.dx[i], rays.dy[i], rays.dz[i], rays.originError[i], rays.directionError[i], scratch);
            meetOnTheWay(i);
        }
    }

    private void meetOnTheWay(int ray) {
        BvhWalk walk = scratch.walk;
        while (walk.nextLeaf(rays.reach(ray))) {
            for (int left = surfaces.inSight(walk.first(), walk.end(), scratch); left != 0; left &= left - 1) {
                surfaces.meet(rays, ray, walk.first() + Integer.numberOfTrailingZeros(left));
            }
        }
    }
}
