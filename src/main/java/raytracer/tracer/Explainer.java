package raytracer.tracer;

import java.util.ArrayList;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** Says how a pixel gets its colour: traces its ray in a batch of its own, and takes note of each step. */
public final class Explainer {

    private final Tracer compiled;
    private final TileTracer tracer;
    private final Rays rays;
    private final Workspace workspace;
    private final Rays towardsLight = new Rays();

    Explainer(Tracer compiled) {
        this.compiled = compiled;
        tracer = new TileTracer(compiled);
        rays = tracer.rays;
        workspace = tracer.workspace;
    }

    /** @param colour of the pixel, not cut to a range */
    public record Explanation(List<Step> steps, Colour colour) { }

    /**
     * A ray and what becomes of it.
     *
     * @param weight how much of its light reaches the pixel
     * @param asNear the numbers of surfaces that are as near as the one it hits, within rounding
     * @param hit    null if it hits nothing
     * @param lights what each light adds, in the order of declaration; empty if nothing is hit or reflects light
     */
    public record Step(Vector origin, Vector direction, Colour weight, List<Integer> asNear, Hit hit,
            List<Lit> lights) { }

    /** @param surface the surface's number in the order of declaration */
    public record Hit(int surface, double distance, Vector point, Vector normal, Material material) { }

    /**
     * A light as it is seen from a hit.
     *
     * @param isFacing  whether it would add anything, were it not blocked
     * @param isBlocked whether it is
     * @param blocker   the number of the first surface in the way; negative if rounding hides which
     * @param blockedAt the distance of that
     * @param distance  of the light; infinite for a directional one
     */
    public record Lit(Colour diffuse, Colour highlight, boolean isFacing, boolean isBlocked, int blocker,
            double blockedAt, double distance) { }

    /** Follows the ray through a pixel's centre; pixels count from the left and the top. */
    public Explanation explain(int x, int y) {
        List<Step> steps = new ArrayList<>();
        Samples samples = new Samples();
        samples.setCentres(x, y, 1, 1);
        tracer.start(samples, 0, 1);
        while (rays.count > 0) {
            tracer.findClosestHits();
            Vector origin = rays.origin.get(0), direction = rays.direction.get(0);
            Colour weight = new Colour(rays.red[0], rays.green[0], rays.blue[0]);
            List<Integer> asNear = rays.hit[0] == Rays.NONE ? List.of() : asNear(rays.hit[0]);
            tracer.moveToHits();
            Hit hit = rays.count == 0 ? null : hit();
            steps.add(new Step(origin, direction, weight, asNear, hit, hit == null ? List.of() : lights(hit.material())));
            tracer.shade();
            tracer.addToSamples();
            tracer.reflect();
        }
        return new Explanation(steps, new Colour(samples.red[0], samples.green[0], samples.blue[0]));
    }

    /** Other surfaces whose distance rounding cannot tell from that of the one that is seen. */
    private List<Integer> asNear(int seen) {
        List<Integer> numbers = new ArrayList<>();
        double[] farthest = {rays.distance[0]};
        collect(rays, (surface, t, error) -> farthest[0] += surface == seen ? Rounding.tie(error, t) : 0);
        collect(rays, (surface, t, error) -> {
            if (surface != seen && t - Rounding.tie(error, t) <= farthest[0]) {
                numbers.add(compiled.table().declared()[surface]);
            }
        });
        numbers.sort(null);
        return numbers;
    }

    private void collect(Rays from, Candidates candidates) {
        for (Surfaces kind : compiled.surfaces()) {
            kind.collect(from, 0, candidates, workspace);
        }
    }

    private Hit hit() {
        int surface = rays.hit[0];
        return new Hit(compiled.table().declared()[surface], rays.distance[0], rays.origin.get(0), rays.normal.get(0),
                compiled.table().materials()[compiled.table().materialIndex()[surface]]);
    }

    private List<Lit> lights(Material material) {
        return material.diffuse().isBlack() && material.specular().isBlack() ? List.of()
                : compiled.lights().stream().map(light -> lit(light, material)).toList();
    }

    private Lit lit(LightSource light, Material material) {
        Shading shading = shade(light, material);
        ShadowRays shadows = shading.shadows;
        if (shading.shadowCount() == 0) {
            return new Lit(Colour.BLACK, Colour.BLACK, false, false, -1, 0, shadows.distance[0]);
        }
        if (!shadows.unoccluded[0]) {
            return blocked(shadows);
        }
        Shading diffuse = shade(light, new Material(Colour.BLACK, material.diffuse(), Colour.BLACK, 1));
        Shading highlight = shade(light, new Material(Colour.BLACK, Colour.BLACK, material.specular(), material.shininess()));
        return new Lit(diffuse.colour(0), highlight.colour(0), true, false, -1, 0, shadows.distance[0]);
    }

    private Shading shade(LightSource light, Material material) {
        Shading shading = new Shading(compiled, List.of(light), rays, workspace);
        shading.shade(0, 1, material);
        return shading;
    }

    private Lit blocked(ShadowRays shadows) {
        towardsLight.set(0, rays.origin.get(0), shadows.direction.get(0));
        towardsLight.source[0] = rays.hit[0];
        towardsLight.originError[0] = shadows.originError[0];
        towardsLight.directionError[0] = 2 * Rounding.U;
        towardsLight.clearHits();
        towardsLight.distance[0] = shadows.distance[0];
        int[] blocker = {-1};
        double[] blockedAt = {shadows.distance[0]};
        collect(towardsLight, (surface, t, error) -> {
            if (t < blockedAt[0]) {
                blocker[0] = compiled.table().declared()[surface];
                blockedAt[0] = t;
            }
        });
        return new Lit(Colour.BLACK, Colour.BLACK, true, true, blocker[0], blockedAt[0], shadows.distance[0]);
    }
}
