package raytracer.tracer.search;

import raytracer.tracer.rays.RayIntervals;
import raytracer.tracer.surface.Workspace;

/** What one thread needs to search for surfaces. */
public record SearchWorkspace(Workspace surfaces, Beam beam, RayIntervals intervals) {

    public SearchWorkspace() {
        this(new Workspace(), new Beam(), new RayIntervals());
    }
}
