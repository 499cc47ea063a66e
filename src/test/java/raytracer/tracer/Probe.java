package raytracer.tracer;

import java.util.List;
import raytracer.parser.Scenes;
import raytracer.scene.Colour;
import raytracer.scene.Scene;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.AnyHit;
import raytracer.tracer.search.ClosestHit;
import raytracer.tracer.search.Ties;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** Shoots single rays at the shapes of a scene that a test writes down. */
public final class Probe {

    private static final String HEAD = "size 1 1\ncamera 0 0 1 0 0 0 0 1 0 45\n";

    private final SurfaceTable table;
    private final List<Surfaces> surfaces;
    private final Rays rays;
    private final Ties ties;
    private final Workspace workspace = new Workspace();

    /** What a ray met: the shape's number in the order of declaration. */
    public record Meeting(int shape, double distance, Vector point, Vector normal) { }

    public Probe(String shapes) throws Exception {
        Scene scene = Scenes.parse(HEAD + shapes).scene();
        SurfaceCompiler compiler = new SurfaceCompiler(scene);
        surfaces = compiler.surfaces();
        table = compiler.table();
        rays = new Rays();
        ties = new Ties(table.declared(), surfaces, rays, workspace);
    }

    /** What a ray from the eye meets; null if nothing. The direction need not be of length 1. */
    public Meeting shoot(Vector origin, Vector direction) {
        aim(origin, direction.unit());
        rays.source[0] = Rays.NONE;
        rays.leaveEye = true;
        rays.originError[0] = 0;
        rays.slide[0] = 0;
        rays.directionError[0] = Rounding.EYE_DIRECTION;
        return meet();
    }

    /** What a ray meets that leaves where the last one arrived; null if nothing. */
    public Meeting continueTowards(Vector direction) {
        rays.source[0] = rays.hit[0];
        rays.leaveEye = false;
        aim(new Vector(rays.ox[0], rays.oy[0], rays.oz[0]), direction.unit());
        return meet();
    }

    /** Whether a light is seen from where the last ray arrived. */
    boolean sees(LightSource light) {
        ShadowRays shadows = new ShadowRays(rays);
        shadows.light = light;
        Vector way = new Vector(light.x(), light.y(), light.z());
        shadows.distance[0] = Double.POSITIVE_INFINITY;
        if (!light.directional()) {
            way = way.minus(new Vector(rays.ox[0], rays.oy[0], rays.oz[0]));
            shadows.distance[0] = way.length();
        }
        Vector unit = way.unit();
        shadows.dx[0] = unit.x();
        shadows.dy[0] = unit.y();
        shadows.dz[0] = unit.z();
        shadows.unoccluded[0] = true;
        shadows.start(0, 1);
        surfaces.forEach(kind -> AnyHit.among(kind, rays, shadows, workspace).run(0, 1));
        return shadows.unoccluded[0];
    }

    /** Whether a light at a point is seen from where the last ray arrived. */
    public boolean seesPoint(Vector p) {
        return sees(new LightSource(false, p.x(), p.y(), p.z(), Colour.BLACK));
    }

    /** Whether a light at infinity is seen from where the last ray arrived. */
    public boolean seesAlong(Vector towards) {
        Vector unit = towards.unit();
        return sees(new LightSource(true, unit.x(), unit.y(), unit.z(), Colour.BLACK));
    }

    private void aim(Vector origin, Vector direction) {
        rays.count = 1;
        rays.ox[0] = origin.x();
        rays.oy[0] = origin.y();
        rays.oz[0] = origin.z();
        rays.dx[0] = direction.x();
        rays.dy[0] = direction.y();
        rays.dz[0] = direction.z();
    }

    private Meeting meet() {
        rays.clearHits();
        surfaces.forEach(kind -> ClosestHit.among(kind, rays, workspace).run(0, rays.count));
        ties.settle();
        int surface = rays.hit[0];
        if (surface == Rays.NONE) {
            return null;
        }
        surfaces.stream().filter(kind -> kind.owns(surface))
                .forEach(kind -> kind.moveToHits(rays, 0, 1, workspace));
        return new Meeting(table.declared()[surface], rays.distance[0],
                new Vector(rays.ox[0], rays.oy[0], rays.oz[0]), new Vector(rays.nx[0], rays.ny[0], rays.nz[0]));
    }
}
