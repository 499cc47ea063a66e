package raytracer.tracer.search;

import java.util.function.IntPredicate;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.surface.Surfaces;

/** Finds what may be in the way of any ray of a bundle. */
public final class BundleSearch {

    private BundleSearch() { }

    /**
     * Whether within a bundle nothing of a kind shows but one surface and what shows at the bundle's corners; false too
     * if they are too many to tell.
     *
     * @param but a surface's index; one of another kind if it can be none
     */
    public static boolean showsNone(Surfaces surfaces, RayBundle bundle, int but, SearchWorkspace space) {
        Beam beam = space.beam();
        return beam.gather(bundle.intervals(), surfaces.bvh())
                && !any(surfaces, k -> surfaces.surface(k) != but && surfaces.mayShowWithin(bundle, k), beam);
    }

    /**
     * Whether any surface of a kind that a bundle may hit blocks all of it; false too if they are too many to tell.
     *
     * @param blocksAll by number among the surfaces
     */
    public static boolean anyBlocksAll(Surfaces surfaces, RayBundle bundle, IntPredicate blocksAll,
            SearchWorkspace space) {
        Beam beam = space.beam();
        return beam.gather(bundle.intervals(), surfaces.bvh()) && any(surfaces, blocksAll, beam);
    }

    private static boolean any(Surfaces surfaces, IntPredicate predicate, Beam beam) {
        for (int k = 0; k < surfaces.bvh().oversized(); k++) {
            if (predicate.test(k)) {
                return true;
            }
        }
        for (int n = 0; n < beam.count; n++) {
            if (predicate.test(beam.primitives[n])) {
                return true;
            }
        }
        return false;
    }
}
