package raytracer.tracer.rays;

import java.util.Arrays;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;

/**
 * From each point that a tile's rays have reached, the way to one light. Ray i here starts where ray i of {@link Rays}
 * has arrived.
 */
public final class ShadowRays {

    // Towards the light: a unit vector. And how far it is; infinite for a directional light.
    public final double[] dx = new double[Batch.CAPACITY];
    public final double[] dy = new double[Batch.CAPACITY];
    public final double[] dz = new double[Batch.CAPACITY];
    public final Vectors direction = new Vectors(dx, dy, dz);
    public final double[] distance = new double[Batch.CAPACITY];

    /** How far off a ray's origin may be, in whatever direction. */
    public final double[] originError = new double[Batch.CAPACITY];

    /** Of each coordinate of the direction: the same for all. */
    public final double[] directionError = new double[Batch.CAPACITY];

    /** Whether it matters that the light is seen, and no surface found so far is in its way. */
    public final boolean[] unoccluded = new boolean[Batch.CAPACITY];

    // What the surface would return of the light, were it not blocked: the cosine at the surface, and the highlight.
    public final double[] lambert = new double[Batch.CAPACITY];
    public final double[] highlight = new double[Batch.CAPACITY];
    /** The squares of the half vectors' lengths, and then of highlights. */
    public final double[] halfSquare = new double[Batch.CAPACITY];

    /** The light that the rays go to. */
    public LightSource light;

    private final Rays rays;

    /** @param rays that will have arrived where these start */
    public ShadowRays(Rays rays) {
        this.rays = rays;
        Arrays.fill(directionError, 2 * Rounding.U);
    }

    /** Sets out from where rays, from one index to another, have arrived. */
    public void start(int from, int end) {
        for (int i = from; i < end; i++) {
            originError[i] = rays.originError[i] + rays.slide[i];
        }
    }

    /** Sets out to a light from where rays, from one index to another, have arrived. */
    public void aim(LightSource to, int from, int end) {
        light = to;
        if (to.directional()) {
            Arrays.fill(dx, from, end, to.x());
            Arrays.fill(dy, from, end, to.y());
            Arrays.fill(dz, from, end, to.z());
            Arrays.fill(distance, from, end, Double.POSITIVE_INFINITY);
            return;
        }
        double lx = to.x(), ly = to.y(), lz = to.z();
        for (int i = from; i < end; i++) {
            dx[i] = lx - rays.ox[i];
            dy[i] = ly - rays.oy[i];
            dz[i] = lz - rays.oz[i];
        }
        direction.normalise(distance, from, end);
    }
}
