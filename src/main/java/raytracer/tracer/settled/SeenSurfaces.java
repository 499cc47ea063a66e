package raytracer.tracer.settled;

import java.util.List;
import raytracer.scene.Vector;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.surface.Surfaces;

/** The few surfaces that some rays hit. */
final class SeenSurfaces {

    /** More are too many for a cell. */
    private static final int MAX = 4;

    private final List<Surfaces> surfaces;
    private final int[] seen = new int[MAX];
    private int count;

    SeenSurfaces(List<Surfaces> surfaces) {
        this.surfaces = surfaces;
    }

    int count() {
        return count;
    }

    void clear() {
        count = 0;
    }

    /** Adds a surface, or {@link Rays#NONE}; false if there is no room for it. */
    boolean add(int surface) {
        if (!has(surface)) {
            if (count == MAX) {
                return false;
            }
            seen[count++] = surface;
        }
        return true;
    }

    boolean has(int surface) {
        for (int n = 0; n < count; n++) {
            if (seen[n] == surface) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether they leave no gap in a bundle that hits nothing else: they are unbounded, or triangles of which each
     * edge in the cell belongs to two.
     */
    boolean cover(RayBundle bundle) {
        boolean isUnbounded = true;
        for (Surfaces kind : surfaces) {
            for (int n = 0; n < count; n++) {
                if (seen[n] != Rays.NONE && kind instanceof BoundedSurfaces bounded && kind.owns(seen[n])) {
                    isUnbounded = false;
                    if (!isInside(bundle, bounded, seen[n] - bounded.surface(0))) {
                        return false;
                    }
                }
            }
        }
        return isUnbounded || isAllOfOneKind();
    }

    /** Whether no edge of a triangle is in the cell, but those that it shares with others that are seen. */
    private boolean isInside(RayBundle bundle, BoundedSurfaces triangles, int k) {
        for (int edge = 0; edge < 3; edge++) {
            Vector a = triangles.corner(k, edge), b = triangles.corner(k, (edge + 1) % 3);
            if (triangles.radius(k) > 0 || !bundle.isOnSide(1, a, b, triangles.corner(k, (edge + 2) % 3))
                    && !isSharedEdge(triangles, k, a, b)) {
                return false;
            }
        }
        return true;
    }

    private boolean isSharedEdge(BoundedSurfaces triangles, int k, Vector a, Vector b) {
        for (int n = 0; n < count; n++) {
            int other = triangles.owns(seen[n]) ? seen[n] - triangles.surface(0) : k;
            if (other != k && isCorner(triangles, other, a) && isCorner(triangles, other, b)) {
                return true;
            }
        }
        return false;
    }

    private static boolean isCorner(BoundedSurfaces triangles, int k, Vector v) {
        return v.equals(triangles.corner(k, 0)) || v.equals(triangles.corner(k, 1)) || v.equals(triangles.corner(k, 2));
    }

    private boolean isAllOfOneKind() {
        for (Surfaces kind : surfaces) {
            if (kind.owns(seen[0])) {
                for (int n = 1; n < count; n++) {
                    if (!kind.owns(seen[n])) {
                        return false;
                    }
                }
                return true;
            }
        }
        return false;
    }
}
