package raytracer.tracer.search;

import java.util.Arrays;
import java.util.List;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/**
 * Decides what a ray hits where rounding cannot tell the distances of several surfaces apart: with e a bound on the
 * error of a distance t and u the least t + e of all surfaces that the ray hits, the first declared with t - e at most
 * u. Being equal within rounding is not transitive, so comparing surfaces in turns would let the order decide in which
 * a search finds them. Here all that are as near are found again, ray by ray; where nothing is, that costs nothing.
 */
public final class Ties implements Candidates {

    private final int[] declared;
    private final List<Surfaces> surfaces;
    private final Rays rays;
    private final Workspace workspace;

    // What the ray hits about where its nearest surface is.
    private int[] found = new int[8];
    private double[] distances = new double[8];
    private double[] errors = new double[8];
    private int count;

    /** @param declared by a surface's index: its number in the order of declaration */
    public Ties(int[] declared, List<Surfaces> surfaces, Rays rays, Workspace workspace) {
        this.declared = declared;
        this.surfaces = surfaces;
        this.rays = rays;
        this.workspace = workspace;
    }

    /** Decides for all rays that have hit several surfaces at about the same distance. */
    public void settle() {
        for (int n = 0; n < rays.closeCount; n++) {
            int ray = rays.close[n];
            // Unless something clearly nearer was found later.
            if (rays.distance[ray] >= rays.closeDistance[ray] * (1 - 4 * Rounding.TIE_SIEVE)) {
                settle(ray);
            }
            rays.closeDistance[ray] = -1;
        }
        rays.closeCount = 0;
    }

    private void settle(int ray) {
        count = 0;
        for (Surfaces kind : surfaces) {
            kind.collect(rays, ray, this, workspace);
        }
        double bound = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            bound = Math.min(bound, distances[i] + errors[i]);
        }
        int first = -1;
        for (int i = 0; i < count; i++) {
            if (distances[i] - errors[i] <= bound && (first < 0 || declared[found[i]] < declared[found[first]])) {
                first = i;
            }
        }
        rays.hit[ray] = found[first];
        rays.distance[ray] = distances[first];
    }

    @Override
    public void add(int surface, double distance, double error) {
        if (count == found.length) {
            found = Arrays.copyOf(found, 2 * count);
            distances = Arrays.copyOf(distances, 2 * count);
            errors = Arrays.copyOf(errors, 2 * count);
        }
        found[count] = surface;
        distances[count] = distance;
        errors[count++] = Rounding.tie(error, distance);
    }
}
