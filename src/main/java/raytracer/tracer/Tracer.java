package raytracer.tracer;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.bvh.TreeFacts;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;

/**
 * A scene compiled for tracing: its surfaces by kind, each with a tree over those that are not too wide for one. Threads share
 * it, and each traces with a {@link TileTracer} of its own.
 *
 * @param scene  what was compiled; its size, camera, maxdepth and lights may be others since
 * @param traced how many rays all threads together have traced, but for shadow rays
 */
public record Tracer(Scene scene, List<Surfaces> surfaces, SurfaceTable table, AtomicLong traced) {

    /** Pixels of a tile's side: the unit of work. */
    public static final int TILE_SIDE = Batch.SIDE;

    public static Tracer compile(Scene scene) {
        SurfaceCompiler compiler = new SurfaceCompiler(scene);
        List<Surfaces> surfaces = compiler.surfaces();
        return new Tracer(scene, surfaces, compiler.table(), new AtomicLong());
    }

    /** The same scene, but that paths from the eye hit at most so many surfaces. */
    public Tracer withMaxDepth(int newMaxDepth) {
        return new Tracer(scene.withMaxDepth(newMaxDepth), surfaces, table, traced);
    }

    /** The same scene of other materials, as many as before. */
    public Tracer withMaterials(Material[] materials) {
        return new Tracer(scene, surfaces, new SurfaceTable(table.declared(), table.materialIndex(), materials), traced);
    }

    /** The same scene in a picture of another size. */
    public Tracer resized(int width, int height) {
        return new Tracer(scene.withSize(width, height), surfaces, table, traced);
    }

    /** The picture's, in pixels. */
    public int width() {
        return scene.width();
    }

    /** The picture's, in pixels. */
    public int height() {
        return scene.height();
    }

    List<LightSource> lights() {
        return scene.lights().stream().map(LightSource::of).toList();
    }

    /** What was built; nothing for kinds of surfaces that the scene does not have. */
    public List<TreeFacts> trees() {
        return surfaces.stream().map(Surfaces::facts).toList();
    }

    /** What follows single rays and says what they find. */
    public Explainer newExplainer() {
        return new Explainer(this);
    }

    /** A tracer for one thread's use. */
    public TileTracer newTileTracer() {
        return new TileTracer(this);
    }
}
