package raytracer.tracer;

import java.util.ArrayList;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.BatchObserver;
import raytracer.tracer.rays.Candidates;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.SearchWorkspace;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;

/** Says how a pixel gets its colour: takes note of each step while its ray is traced, in a batch of its own. */
public final class Explainer implements BatchObserver {

    private final TileTracer tracer;
    private final List<Surfaces> surfaces;
    private final SurfaceTable table;
    private final Rays rays;
    private final SearchWorkspace space;
    private final Rays towardsLight = new Rays();

    private List<Step> steps;
    private Step step;
    private boolean isFacing;

    Explainer(Tracer scene) {
        tracer = new TileTracer(scene);
        surfaces = scene.surfaces();
        table = scene.table();
        rays = tracer.rays;
        space = tracer.space;
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
        steps = new ArrayList<>();
        Samples samples = new Samples();
        samples.setCentres(x, y, 1, 1);
        tracer.trace(samples, this);
        return new Explanation(steps, new Colour(samples.red[0], samples.green[0], samples.blue[0]));
    }

    @Override
    public void found() {
        Colour weight = new Colour(rays.red[0], rays.green[0], rays.blue[0]);
        List<Integer> asNear = rays.hit[0] == Rays.NONE ? List.of() : asNear(rays.hit[0]);
        step = new Step(rays.origin.get(0), rays.direction.get(0), weight, asNear, null, List.of());
        steps.add(step);
    }

    /** Other surfaces whose distance rounding cannot tell from that of the one that is seen. */
    private List<Integer> asNear(int seen) {
        List<Integer> numbers = new ArrayList<>();
        double[] farthest = {rays.distance[0]};
        collect(rays, (surface, t, error) -> farthest[0] += surface == seen ? Rounding.tie(error, t) : 0);
        collect(rays, (surface, t, error) -> {
            if (surface != seen && t - Rounding.tie(error, t) <= farthest[0]) {
                numbers.add(table.declared()[surface]);
            }
        });
        return numbers;
    }

    private void collect(Rays from, Candidates candidates) {
        for (Surfaces kind : surfaces) {
            kind.collect(from, 0, candidates, space.surfaces());
        }
    }

    @Override
    public void moved() {
        if (rays.count > 0) {
            int surface = rays.hit[0];
            Hit hit = new Hit(table.declared()[surface], rays.distance[0], rays.origin.get(0), rays.normal.get(0),
                    table.materials()[table.materialIndex()[surface]]);
            step = new Step(step.origin, step.direction, step.weight, step.asNear, hit, new ArrayList<>());
            steps.set(steps.size() - 1, step);
        }
    }

    @Override
    public void aimed(int from, int to, ShadowRays shadows) {
        isFacing = shadows.unoccluded[0];
    }

    @Override
    public void lit(int from, int to, ShadowRays shadows, Material material) {
        if (isFacing && !shadows.unoccluded[0]) {
            step.lights.add(blocked(shadows));
            return;
        }
        Colour diffuse = part(shadows.light, new Material(Colour.BLACK, material.diffuse(), Colour.BLACK, 1));
        Colour highlight = part(shadows.light,
                new Material(Colour.BLACK, Colour.BLACK, material.specular(), material.shininess()));
        step.lights.add(new Lit(diffuse, highlight, isFacing, false, -1, 0, shadows.distance[0]));
    }

    /** What a light adds to a material. */
    private Colour part(LightSource light, Material material) {
        Shading shading = new Shading(surfaces, List.of(light), rays, space);
        shading.shade(0, 1, material, null);
        return new Colour(shading.red[0], shading.green[0], shading.blue[0]);
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
                blocker[0] = table.declared()[surface];
                blockedAt[0] = t;
            }
        });
        return new Lit(Colour.BLACK, Colour.BLACK, true, true, blocker[0], blockedAt[0], shadows.distance[0]);
    }
}
