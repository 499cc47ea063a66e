package raytracer.tracer;

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
}
