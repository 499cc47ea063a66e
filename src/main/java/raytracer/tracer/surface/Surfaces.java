package raytracer.tracer.surface;

import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.bvh.TreeFacts;
import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.RayIntervals;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;

/**
 * All surfaces of one kind. Each has an index, a number that is its own among all kinds; what is known of it by index
 * lies in arrays. A tree finds the few that a ray may hit; those that are too wide for it, every ray tries. A scene
 * without a kind has no object for it, and so no code of it runs.
 */
public abstract class Surfaces {

    private final String name;
    private final int firstSurface;
    private final int count;
    private final Bvh bvh;

    /** @param name of the kind, in the plural */
    protected Surfaces(String name, int firstSurface, Bvh bvh) {
        this.name = name;
        this.firstSurface = firstSurface;
        this.bvh = bvh;
        count = bvh.order().length;
    }

    /**
     * The distance at which a ray hits the surface with this number among these; NaN if it does not, or farther away
     * than {@link Rays#maxDistance}.
     */
    protected abstract double distance(Rays rays, int ray, int k);

    /** Bounds the error of that distance. */
    protected abstract double distanceError(Rays rays, int ray, int k, double t);

    /** Records the surface with this number among these for a ray, if it hits it. */
    public final void intersect(Rays rays, int ray, int k) {
        double t = distance(rays, ray, k);
        if (t > 0) {
            rays.record(ray, surface(k), t);
        }
    }

    /** Adds all of these that a ray hits no farther away than {@link Rays#maxDistance}. */
    public final void collect(Rays rays, int ray, Candidates candidates, Workspace workspace) {
        for (int k = 0; k < bvh.oversized(); k++) {
            collect(rays, ray, k, candidates);
        }
        BvhWalk walk = workspace.walk;
        if (walk.start(bvh, rays.ox[ray], rays.oy[ray], rays.oz[ray], rays.dx[ray], rays.dy[ray], rays.dz[ray])) {
            while (walk.nextLeaf(rays.maxDistance(ray))) {
                for (int k = walk.first; k < walk.end; k++) {
                    collect(rays, ray, k, candidates);
                }
            }
        }
    }

    private void collect(Rays rays, int ray, int k, Candidates candidates) {
        double t = distance(rays, ray, k);
        if (t > 0) {
            candidates.add(surface(k), t, distanceError(rays, ray, k, t));
        }
    }

    /** Whether the surface with this number among these is strictly between a point and its light. */
    public abstract boolean blocks(Rays rays, ShadowRays shadows, int ray, int k);

    /**
     * Moves rays, from one index to another, that have hit these to where they hit them: their origins become those
     * points, with bounds on their errors, and the normals are set.
     */
    public abstract void moveToHits(Rays rays, int from, int to, Workspace workspace);

    /** Whether {@link #mayHit} goes by {@link Workspace#line}, which then must be set; no, unless a kind says so. */
    public boolean hasSieve() {
        return false;
    }

    /**
     * Which of some surfaces, no more than a leaf has, a ray may hit that is in {@link Workspace#line}: a bit for each,
     * the first one's lowest; all, if there is no sieve. No branch depends on it, for the processor would often guess wrong.
     */
    public int mayHit(int first, int end, Workspace workspace) {
        return (1 << end - first) - 1;
    }

    /**
     * Keeps, of some surfaces' numbers, those that rays in these intervals may hit, after {@link #prepareToIntersect} or
     * {@link #prepareToBlock}.
     *
     * @return how many are kept
     */
    public int sift(RayIntervals rays, int[] numbers, int count, Workspace workspace) {
        return count;
    }

    public final TreeFacts facts() {
        return TreeFacts.of(name, bvh);
    }

    public final Bvh bvh() {
        return bvh;
    }

    /** The index of the surface with this number among these. */
    public final int surface(int k) {
        return firstSurface + k;
    }

    protected final int number(int surface) {
        return surface - firstSurface;
    }

    /** Whether the surface with this index is one of these. */
    public final boolean owns(int surface) {
        return surface >= firstSurface && surface < firstSurface + count;
    }

    /** Computes what {@link #intersectAll} needs to know of rays, from one index to another. */
    public void prepareToIntersect(Rays rays, int from, int to, Workspace workspace) { }

    /** Computes what {@link #blockAll} needs to know of shadow rays, from one index to another. */
    public void prepareToBlock(Rays rays, ShadowRays shadows, int from, int to, Workspace workspace) { }

    /** Records the surface with this number among these for rays, from one index to another, that hit it. */
    public abstract void intersectAll(Rays rays, int from, int to, int k, Workspace workspace);

    /** Occludes every shadow ray from one index to another that the surface with this number among these blocks. */
    public abstract void blockAll(Rays rays, ShadowRays shadows, int from, int to, int k, Workspace workspace);
}
