package raytracer.tracer.search;

import raytracer.tracer.surface.Workspace;

/** What one thread needs to search for surfaces. */
public record SearchWorkspace(Workspace surfaces, Beam beam) {

    public SearchWorkspace() {
        this(new Workspace(), new Beam());
    }
}
