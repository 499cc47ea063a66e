package raytracer.tracer.search;

import java.util.function.IntPredicate;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.surface.BoundedSurfaces;

/** Finds what may be in the way of any ray of a bundle. */
public final class BundleSearch {

    private BundleSearch() { }

    /**
     * Whether a bundle can hit no surface of a kind but one; false too if they are too many to tell.
     *
     * @param but a surface's index; one of another kind if it can hit none
     */
    public static boolean hitsNone(BoundedSurfaces surfaces, RayBundle bundle, int but, SearchWorkspace space) {
        Beam beam = space.beam();
        beam.enclose(bundle);
        return beam.gather(surfaces.bvh())
                && !any(surfaces, k -> surfaces.surface(k) != but && !isClear(surfaces, bundle, k), beam);
    }

    /**
     * Whether any surface of a kind that a bundle may hit blocks all of it; false too if they are too many to tell.
     *
     * @param blocksAll by number among the surfaces
     */
    public static boolean anyBlocksAll(BoundedSurfaces surfaces, RayBundle bundle, IntPredicate blocksAll,
            SearchWorkspace space) {
        Beam beam = space.beam();
        beam.enclose(bundle);
        return beam.gather(surfaces.bvh()) && any(surfaces, blocksAll, beam);
    }

    private static boolean any(BoundedSurfaces surfaces, IntPredicate predicate, Beam beam) {
        for (int k = 0; k < surfaces.bvh().oversized(); k++) {
            if (predicate.test(k)) {
                return true;
            }
        }
        for (int n = 0; n < beam.count(); n++) {
            if (predicate.test(beam.primitive(n))) {
                return true;
            }
        }
        return false;
    }

    private static boolean isClear(BoundedSurfaces surfaces, RayBundle bundle, int k) {
        return bundle.isClearOf(surfaces.corner(k, 0), surfaces.corner(k, 1), surfaces.corner(k, 2), surfaces.radius(k));
    }
}
