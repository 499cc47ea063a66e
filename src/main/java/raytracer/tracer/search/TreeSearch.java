package raytracer.tracer.search;

import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.rays.RayIntervals;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/**
 * Searches surfaces of one kind for what a batch of rays hits. If the rays' {@link Beam} finds few surfaces, all rays try
 * those; else each ray walks the tree, from the deepest node that holds all that the beam may hit. For one thread.
 */
abstract class TreeSearch implements Search {

    /** The most surfaces that are still worth trying with every ray, if it takes the robust arithmetic of single rays. */
    private static final int FEW = 24;

    final Surfaces surfaces;
    final Bvh bvh;
    final Rays rays;
    final Workspace workspace;

    /** Where the searched rays are. */
    final RayIntervals intervals = new RayIntervals();

    private final Beam beam = new Beam();
    private final Vectors direction;
    private final double[] originError;
    private final double[] directionError;

    /** @param direction in which to search, from where rays start; the errors are bounds on those of both */
    TreeSearch(Surfaces surfaces, Rays rays, Vectors direction, double[] originError, double[] directionError,
            Workspace workspace) {
        this.surfaces = surfaces;
        this.rays = rays;
        this.direction = direction;
        this.originError = originError;
        this.directionError = directionError;
        this.workspace = workspace;
        bvh = surfaces.bvh();
    }

    /** Takes in what is searched, in {@link #intervals}. */
    abstract void enclose(int from, int to);

    /** Computes what {@link #tryAll} needs to know of rays. */
    abstract void prepare(int from, int to);

    /** Tries one surface with all rays. */
    abstract void tryAll(int from, int to, int k);

    /** Tries a likely surface with one ray, if there is one; returns whether nothing has to be searched for it. */
    abstract boolean tryLikely(int ray);

    /** What is farther away along a ray does not matter. */
    abstract double maxDistance(int ray);

    /** Tries one surface with one ray; returns whether the ray's search is over. */
    abstract boolean tryOne(int ray, int k);

    @Override
    public void find(int from, int to) {
        if (bvh.oversized() > 0) {
            tryOversized(from, to);
        }
        enclose(from, to);
        if (!beam.gather(intervals, bvh, surfaces.hasSieve() ? FEW + (to - from) / 2 : FEW)) {
            walk(from, to);
        } else if (beam.count > 0) {
            prepare(from, to);
            beam.count = surfaces.sift(intervals, beam.primitives, beam.count, workspace);
            if (beam.count > maxTried(to - from)) {
                walk(from, to);
            } else {
                tryGathered(from, to);
            }
        }
    }

    /** So many surfaces are worth trying with every ray: more where loops of vectors clear most rays of them. */
    private int maxTried(int count) {
        return surfaces.hasSieve() && workspace.lines.areAlike() ? FEW + count / 4 : FEW;
    }

    /** Tries what is too wide for the tree with all rays. */
    final void tryOversized(int from, int to) {
        prepare(from, to);
        for (int k = 0; k < bvh.oversized(); k++) {
            tryAll(from, to, k);
        }
    }

    private void tryGathered(int from, int to) {
        for (int n = 0; n < beam.count; n++) {
            tryAll(from, to, beam.primitives[n]);
        }
    }

    // One ray's walk is a method of its own: HotSpot compiles it by its number of calls, long before the loop over rays.

    private void walk(int from, int to) {
        for (int i = from; i < to; i++) {
            if (!tryLikely(i)) {
                walk(i);
            }
        }
    }

    private void walk(int i) {
        BvhWalk walk = workspace.walk;
        if (walk.start(bvh, rays.ox[i], rays.oy[i], rays.oz[i], direction.x()[i], direction.y()[i], direction.z()[i])) {
            walk.enter(beam.entry);
            if (surfaces.hasSieve()) {
                workspace.line.set(walk, direction.x()[i], direction.y()[i], direction.z()[i],
                        originError[i] * bvh.space().scale(), directionError[i]);
            }
            tryLeaves(i, walk);
        }
    }

    private void tryLeaves(int ray, BvhWalk walk) {
        while (walk.nextLeaf(maxDistance(ray))) {
            int bits = surfaces.mayHit(walk.first, walk.end, workspace);
            for (; bits != 0; bits &= bits - 1) {
                if (tryOne(ray, walk.first + Integer.numberOfTrailingZeros(bits))) {
                    return;
                }
            }
        }
    }
}
