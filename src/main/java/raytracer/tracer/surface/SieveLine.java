package raytracer.tracer.surface;

import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.BvhWalk;

/**
 * A ray's line as a sieve in floats wants it: its direction and moment, origin x direction, in the space of the tree.
 * One object serves ray after ray.
 */
public final class SieveLine {

    /**
     * Of an edge's bound: floats' rounding of a side. With v = 2^-24 and coordinates up to 1, directions, moments,
     * edges and products are off by v, which is sqrt 3 v in a side each, and each of its terms is rounded 7 times,
     * 14 sqrt 3 v: 31.2v in all.
     */
    private static final double ROUNDING = 40 * 0x1p-24;

    public float dx, dy, dz;
    public float momentX, momentY, momentZ;

    /** By how much a side may be off, for each unit of an edge's length. */
    public float tolerance;

    /**
     * Lets the line go in a direction through the point where a walk has taken up its ray.
     *
     * @param originError of each coordinate, in tree space
     */
    public void set(BvhWalk walk, double dx, double dy, double dz, double originError, double directionError) {
        this.dx = (float) dx;
        this.dy = (float) dy;
        this.dz = (float) dz;
        momentX = (float) (walk.y * dz - walk.z * dy);
        momentY = (float) (walk.z * dx - walk.x * dz);
        momentZ = (float) (walk.x * dy - walk.y * dx);
        // No corner in the tree's cube is farther from the ray's origin; by |x| + |y| + |z| it is sqrt 3 times as far.
        double l1Norm = 2 * (walk.start + 4);
        // The robust test takes what is within the bound by what it has computed, which is off by as much (twice the
        // side for edges up to twice as long as the bound here); and a walk moves the origin, by which a side is off
        // by less than another two such bounds.
        tolerance = (float) (ROUNDING + 4 * Rounding.edge(originError, directionError, l1Norm, 1));
    }
}
