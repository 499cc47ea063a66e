package raytracer.tracer.search;

import java.util.ArrayList;
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

    /** What the ray hits about where its nearest surface is. */
    private final List<Found> found = new ArrayList<>();

    private record Found(int surface, double distance, double error) { }

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
        found.clear();
        for (Surfaces kind : surfaces) {
            kind.collect(rays, ray, this, workspace);
        }
        double bound = Double.POSITIVE_INFINITY;
        for (Found f : found) {
            bound = Math.min(bound, f.distance + f.error);
        }
        Found first = null;
        for (Found f : found) {
            if (f.distance - f.error <= bound && (first == null || declared[f.surface] < declared[first.surface])) {
                first = f;
            }
        }
        rays.hit[ray] = first.surface;
        rays.distance[ray] = first.distance;
    }

    @Override
    public void add(int surface, double distance, double error) {
        found.add(new Found(surface, distance, Rounding.tie(error, distance)));
    }
}
