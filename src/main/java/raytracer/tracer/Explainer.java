package raytracer.tracer;

import java.util.ArrayList;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Vector;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.search.ClosestHit;
import raytracer.tracer.search.SearchWorkspace;
import raytracer.tracer.search.Ties;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;

/**
 * The algorithm for one ray, step by step: what {@link TileTracer} does for many, by the same kernels on a batch of
 * one. Each step says what it found.
 */
public final class Explainer {

    private final Pinhole pinhole;
    private final List<Surfaces> surfaces;
    private final SurfaceTable table;
    private final List<LightSource> lights;
    private final int maxDepth;

    private final SearchWorkspace space = new SearchWorkspace();
    private final Rays rays = new Rays();
    private final Rays towardsLight = new Rays();

    Explainer(Pinhole pinhole, List<Surfaces> surfaces, SurfaceTable table, List<LightSource> lights, int maxDepth) {
        this.pinhole = pinhole;
        this.surfaces = surfaces;
        this.table = table;
        this.lights = lights;
        this.maxDepth = maxDepth;
    }

    /** Where a path ends. */
    public enum End { HITS_NOTHING, MAX_DEPTH, NO_MIRROR, GOES_ON }

    /**
     * A ray and what becomes of it.
     *
     * @param weight how much of its light reaches the pixel
     * @param hit    null if it hits nothing
     * @param lights what each light adds, in the order of declaration; empty if nothing is hit
     */
    public record Step(Vector origin, Vector direction, Colour weight, Hit hit, List<Lit> lights, End end) { }

    /**
     * @param surface the surface's number in the order of declaration
     * @param asNear  the numbers of others that are as near, within rounding
     */
    public record Hit(int surface, double distance, Vector point, Vector normal, Material material,
            List<Integer> asNear) { }

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

    /** The steps of the ray through a pixel's centre, from the eye on; pixels count from the left and the top. */
    public List<Step> explain(int x, int y) {
        Samples samples = new Samples();
        samples.setCentres(x, y, 1, 1);
        rays.start(pinhole.aiming(rays), samples, 0, 1);
        List<Step> steps = new ArrayList<>();
        Colour weight = new Colour(1, 1, 1);
        for (int depth = 1; ; depth++) {
            Step step = step(weight, depth);
            steps.add(step);
            if (step.end != End.GOES_ON) {
                return steps;
            }
            Colour mirror = step.hit.material.specular();
            weight = new Colour(weight.red() * mirror.red(), weight.green() * mirror.green(),
                    weight.blue() * mirror.blue());
            rays.leaveEye = false;
            rays.mirror();
        }
    }

    private Step step(Colour weight, int depth) {
        Vector origin = origin(), direction = new Vector(rays.dx[0], rays.dy[0], rays.dz[0]);
        rays.clearHits();
        for (Surfaces kind : surfaces) {
            Kernel.run(ClosestHit.among(kind, rays, space), 0, 1);
        }
        new Ties(table.declared(), surfaces, rays, space.surfaces()).settle();
        int surface = rays.hit[0];
        if (surface == Rays.NONE) {
            return new Step(origin, direction, weight, null, List.of(), End.HITS_NOTHING);
        }
        List<Integer> asNear = asNear(surface);
        for (Surfaces kind : surfaces) {
            if (kind.owns(surface)) {
                kind.moving(rays, space.surfaces()).run(0, 1);
            }
        }
        Material material = table.materials()[table.materialIndex()[surface]];
        Hit hit = new Hit(table.declared()[surface], rays.distance[0], origin(),
                new Vector(rays.nx[0], rays.ny[0], rays.nz[0]), material, asNear);
        End end = depth == maxDepth ? End.MAX_DEPTH : material.specular().isBlack() ? End.NO_MIRROR : End.GOES_ON;
        List<Lit> lit = lights.stream().map(light -> lit(light, material)).toList();
        return new Step(origin, direction, weight, hit, lit, end);
    }

    private Vector origin() {
        return new Vector(rays.ox[0], rays.oy[0], rays.oz[0]);
    }

    /** Other surfaces whose distance rounding cannot tell from that of the one that is seen. */
    private List<Integer> asNear(int seen) {
        List<Integer> numbers = new ArrayList<>();
        double[] reach = new double[1];
        for (int round = 0; round < 2; round++) {
            boolean isSecond = round == 1;
            for (Surfaces kind : surfaces) {
                kind.collect(rays, 0, (surface, distance, error) -> {
                    double slack = Rounding.tie(error, distance);
                    if (surface == seen) {
                        reach[0] = distance + slack;
                    } else if (isSecond && distance - slack <= reach[0]) {
                        numbers.add(table.declared()[surface]);
                    }
                }, space.surfaces());
            }
        }
        return numbers;
    }

    private Lit lit(LightSource light, Material material) {
        Colour diffuse = part(light, new Material(Colour.BLACK, material.diffuse(), Colour.BLACK, 1));
        Colour highlight = part(light,
                new Material(Colour.BLACK, Colour.BLACK, material.specular(), material.shininess()));
        Shading whole = new Shading(surfaces, List.of(light), rays, space);
        whole.shade(0, 1, material, null);
        double distance = whole.lightDistance(0);
        if (whole.shadowCount() == 0 || whole.isUnoccluded(0)) {
            return new Lit(diffuse, highlight, whole.shadowCount() > 0, false, -1, 0, distance);
        }
        return blocked(light, distance);
    }

    /** What a light adds to a material. */
    private Colour part(LightSource light, Material material) {
        Shading shading = new Shading(surfaces, List.of(light), rays, space);
        shading.shade(0, 1, material, null);
        return new Colour(shading.red[0], shading.green[0], shading.blue[0]);
    }

    private Lit blocked(LightSource light, double distance) {
        Vector way = new Vector(light.x(), light.y(), light.z());
        Vector unit = (light.directional() ? way : way.minus(origin())).unit();
        towardsLight.set(0, origin(), unit);
        towardsLight.source[0] = rays.hit[0];
        towardsLight.originError[0] = rays.originError[0] + rays.slide[0];
        towardsLight.directionError[0] = 2 * Rounding.U;
        towardsLight.clearHits();
        towardsLight.distance[0] = distance;
        int[] blocker = {-1};
        double[] blockedAt = {distance};
        for (Surfaces kind : surfaces) {
            kind.collect(towardsLight, 0, (surface, t, error) -> {
                if (t < blockedAt[0]) {
                    blocker[0] = table.declared()[surface];
                    blockedAt[0] = t;
                }
            }, space.surfaces());
        }
        return new Lit(Colour.BLACK, Colour.BLACK, true, true, blocker[0], blockedAt[0], distance);
    }
}
