package raytracer.tracer;

import java.util.Arrays;

/**
 * From each point that a tile's rays have reached, the way to one light. Ray i here starts where ray i of {@link Rays}
 * has arrived.
 */
final class ShadowRays {

    // Towards the light: a unit vector. And how far it is; infinite for a directional light.
    final double[] dx = new double[Rays.CAPACITY];
    final double[] dy = new double[Rays.CAPACITY];
    final double[] dz = new double[Rays.CAPACITY];
    final double[] distance = new double[Rays.CAPACITY];

    /** Whether it matters that the light is seen, and no surface found so far is in its way. */
    final boolean[] open = new boolean[Rays.CAPACITY];

    // What the surface would return of the light, were it not blocked: the cosine at the surface, and the highlight.
    final double[] lambert = new double[Rays.CAPACITY];
    final double[] highlight = new double[Rays.CAPACITY];

    /** The light that the rays go to. */
    Lamp lamp;

    /** Sets out to a lamp from where rays, from one index to another, have arrived. */
    void aim(Rays rays, Lamp to, int from, int end) {
        lamp = to;
        if (to.directional()) {
            Arrays.fill(dx, from, end, to.x());
            Arrays.fill(dy, from, end, to.y());
            Arrays.fill(dz, from, end, to.z());
            Arrays.fill(distance, from, end, Double.POSITIVE_INFINITY);
            return;
        }
        Passes.subtract(to.x(), rays.ox, dx, from, end);
        Passes.subtract(to.y(), rays.oy, dy, from, end);
        Passes.subtract(to.z(), rays.oz, dz, from, end);
        Passes.length(dx, dy, dz, distance, from, end);
        Passes.divide(dx, dy, dz, distance, from, end);
    }
}
