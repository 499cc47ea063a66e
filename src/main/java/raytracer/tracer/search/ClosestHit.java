package raytracer.tracer.search;

import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.lightbuffer.LazyLightBuffer;
import raytracer.tracer.lightbuffer.LightBuffer;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.surface.SieveLine;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.UnboundedSurfaces;

/**
 * Records the closest hit of each of a batch's rays with surfaces of one kind. Those from the eye have a light
 * buffer.
 */
public final class ClosestHit extends Search {

    private final LazyLightBuffer ofEye;

    /** @param eye where rays start, if they leave the eye */
    public static Kernel among(Surfaces kind, Rays rays, LightSource eye, SearchWorkspace space) {
        return kind instanceof BoundedSurfaces bounded
                ? new ClosestHit(bounded, rays, bounded.lightBuffer(eye), space)
                : ((UnboundedSurfaces) kind).intersecting(rays, space.surfaces());
    }

    /** @param ofEye null if there is none, nor will be */
    private ClosestHit(BoundedSurfaces surfaces, Rays rays, LazyLightBuffer ofEye, SearchWorkspace space) {
        super(surfaces, rays, rays.direction, space);
        this.ofEye = ofEye;
    }

    @Override
    boolean isDoneWithoutBeam(int from, int to) {
        return false;
    }

    @Override
    void encloseInBeam(int from, int to) {
        space.beam().enclose(rays, from, to);
    }

    @Override
    LightBuffer bufferInsteadOfWalks(int from, int to) {
        return rays.leaveEye && ofEye != null ? ofEye.insteadOfWalks(to - from) : null;
    }

    @Override
    void prepare(int from, int to) {
        surfaces.prepareToIntersect(rays, from, to, space.surfaces());
    }

    @Override
    void tryAll(int from, int to, int k) {
        surfaces.intersectAll(rays, from, to, k, space.surfaces());
    }

    @Override
    boolean isSearching(int ray) {
        return true;
    }

    @Override
    double maxDistance(int ray) {
        return rays.maxDistance(ray);
    }

    @Override
    boolean isLast(int ray, int k) {
        surfaces.intersect(rays, ray, k);
        return false;
    }

    @Override
    void setDirection(SieveLine line, int i) {
        line.setDirection(rays.dx[i], rays.dy[i], rays.dz[i], rays.originError[i] * bvh.space().scale(),
                rays.directionError[i]);
    }

    @Override
    void findCells(int from, int to) {
        buffer.findAhead(rays, from, to, space.cells());
    }

    @Override
    void shortenCell(int ray) {
        buffer.limit(rays.maxDistance(ray), ray, space.cells());
    }
}
