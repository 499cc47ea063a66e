package raytracer.tracer;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.scene.Scene;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.bvh.TreeFacts;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;

/**
 * A scene compiled for tracing: its surfaces by kind, each with a tree over those that are not too wide for one. Immutable;
 * threads share it, and each traces with a {@link TileTracer} of its own.
 *
 * @param traced how many rays all threads together have traced, but for shadow rays
 */
public record Tracer(Pinhole pinhole, List<Surfaces> surfaces, SurfaceTable table, List<LightSource> lights, int maxDepth,
        AtomicLong traced) {

    /** Pixels of a tile's side: the unit of work. */
    public static final int TILE_SIDE = Batch.SIDE;

    public static Tracer compile(Scene scene) {
        SurfaceCompiler compiler = new SurfaceCompiler(scene);
        List<Surfaces> surfaces = compiler.surfaces();
        return new Tracer(new Pinhole(scene), surfaces, compiler.table(),
                scene.lights().stream().map(LightSource::of).toList(), scene.maxDepth(), new AtomicLong());
    }

    /** The same scene, but that paths from the eye hit at most so many surfaces. */
    public Tracer withMaxDepth(int newMaxDepth) {
        return new Tracer(pinhole, surfaces, table, lights, newMaxDepth, traced);
    }

    /** The same scene in a picture so many times as wide and as high. */
    public Tracer enlarged(int factor) {
        return new Tracer(pinhole.enlarged(factor), surfaces, table, lights, maxDepth, traced);
    }

    /** The picture's, in pixels. */
    public int width() {
        return pinhole.width();
    }

    /** The picture's, in pixels. */
    public int height() {
        return pinhole.height();
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
