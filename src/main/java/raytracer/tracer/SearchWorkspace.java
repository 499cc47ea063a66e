package raytracer.tracer;

/** What one thread needs to search for surfaces. */
record SearchWorkspace(Workspace surfaces, Beam beam, LightBuffer.Cells cells) {

    SearchWorkspace() {
        this(new Workspace(), new Beam(), new LightBuffer.Cells());
    }
}
