package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Vector;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.BundleSearch;
import raytracer.tracer.search.SearchWorkspace;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.UnboundedSurfaces;

/**
 * Proves of the cells of a lattice of samples that there is nothing in them but what their corners show: no other surface
 * in front, no edge of a shadow, and so on along mirrors, as far as their light can change a pixel (Genetti, Gordon and
 * Williams, Adaptive Supersampling in Object Space Using Pyramidal Rays, 1998). It watches a batch being traced. What is
 * proved of a rectangle of cells is proved of each; where that fails, its halves are tried, down to single cells.
 */
final class SettledCells {

    /** The most surfaces that a cell may show. */
    private static final int MAX_SEEN = 4;

    /** By how many times the tolerance the colours of a cell's corners may differ. */
    private static final double MAX_RANGE = 16;

    private final List<Surfaces> surfaces;
    private final Rays rays;
    private final SearchWorkspace space;
    private final RayBundle bundle = new RayBundle();

    private int columns;
    private int rows;
    private double tolerance;
    private boolean[] settled;
    private boolean[] isMixed;

    // By point of the lattice, row by row: the ray there before it moved to its hit, and the hit.
    private final Vectors origin = new Vectors();
    private final Vectors direction = new Vectors();
    private final double[] distance = new double[Batch.CAPACITY];
    private final int[] hit = new int[Batch.CAPACITY];
    private final double[] weight = new double[Batch.CAPACITY];
    private final Vectors point = new Vectors();
    private final Vectors normal = new Vectors();
    /** Its ray's index among those that are looked at now; negative if it is none of them. */
    private final int[] rayOf = new int[Batch.CAPACITY];
    private final boolean[] isAimed = new boolean[Batch.CAPACITY];

    private final int[] seen = new int[MAX_SEEN];
    private int seenCount;

    // The light that is looked at now, and its direction from each point.
    private final Vectors towardsLight = new Vectors();
    private final double[] lightDistance = new double[Batch.CAPACITY];
    /** From the normal to the half vector. */
    private final Vector[] chord = new Vector[Batch.CAPACITY];
    private ShadowRays shadows;
    private Material material;

    /** What is to be proved of a rectangle of lattice points, whose sides are inclusive. */
    private interface Claim {
        boolean holds(int left, int top, int right, int bottom);
    }

    SettledCells(List<Surfaces> surfaces, Rays rays, SearchWorkspace space) {
        this.surfaces = surfaces;
        this.rays = rays;
        this.space = space;
    }

    /** @param tolerance by how much a pixel's colour may be off without more samples, of a range of [0, 1] */
    void start(int latticeColumns, int latticeRows, double tolerance) {
        columns = latticeColumns;
        rows = latticeRows;
        this.tolerance = tolerance;
        settled = new boolean[(columns - 1) * (rows - 1)];
        Arrays.fill(settled, true);
        isMixed = new boolean[settled.length];
    }

    /** Takes note of all rays, which have found what they hit and are still where they started. */
    void found() {
        Arrays.fill(rayOf, -1);
        for (int i = 0; i < rays.count; i++) {
            int p = rays.pixel[i];
            rayOf[p] = i;
            origin.set(p, rays.origin, i);
            direction.set(p, rays.direction, i);
            distance[p] = rays.distance[i];
            hit[p] = rays.hit[i];
            weight[p] = rays.leaveEye ? 1 : Math.max(rays.red[i], Math.max(rays.green[i], rays.blue[i]));
        }
    }

    /** Takes note of where those that hit something have moved, and proves that nothing else is in front of that. */
    void moved() {
        for (int i = 0; i < rays.count; i++) {
            int p = rays.pixel[i];
            point.set(p, rays.origin, i);
            normal.set(p, rays.normal, i);
        }
        prove(this::showsWhatItsCornersShow, 0, 0, columns - 1, rows - 1);
    }

    private void prove(Claim claim, int left, int top, int right, int bottom) {
        if (!isAnySettled(left, top, right, bottom) || claim.holds(left, top, right, bottom)) {
            return;
        }
        if (isCell(left, top, right, bottom)) {
            settled[top * (columns - 1) + left] = false;
        } else if (right - left > bottom - top) {
            int middle = (left + right) >>> 1;
            prove(claim, left, top, middle, bottom);
            prove(claim, middle, top, right, bottom);
        } else {
            int middle = (top + bottom) >>> 1;
            prove(claim, left, top, right, middle);
            prove(claim, left, middle, right, bottom);
        }
    }

    private static boolean isCell(int left, int top, int right, int bottom) {
        return right - left == 1 && bottom - top == 1;
    }

    private boolean isAnySettled(int left, int top, int right, int bottom) {
        for (int row = top; row < bottom; row++) {
            for (int column = left; column < right; column++) {
                if (settled[row * (columns - 1) + column]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The lattice point at one of a rectangle's corners, in their order around it. */
    private int corner(int corner, int left, int top, int right, int bottom) {
        return (corner < 2 ? top : bottom) * columns + (corner == 0 || corner == 3 ? left : right);
    }

    private boolean showsWhatItsCornersShow(int left, int top, int right, int bottom) {
        int rayCount = count(left, top, right, bottom);
        if (rayCount == 0) {
            return true;
        }
        if (rayCount < (right - left + 1) * (bottom - top + 1) || !findSeen(left, top, right, bottom)) {
            return false;
        }
        boolean isCell = isCell(left, top, right, bottom);
        if (isFaint(left, top, right, bottom)) {
            return true;
        }
        if (seenCount > 1 && !isCell) {
            return false;
        }
        bundle.clear();
        for (int row = top; row <= bottom; row++) {
            bundle.include(origin, direction, distance, row * columns + left, row * columns + right + 1);
        }
        for (int corner = 0; corner < RayBundle.CORNERS; corner++) {
            int p = corner(corner, left, top, right, bottom);
            Vector at = hit[p] == Rays.NONE ? null : point.get(p);
            bundle.setCorner(corner, origin.get(p), direction.get(p), at, normal.get(p));
        }
        bundle.close();
        if (!hitsOnlyWhatIsSeen() || seenCount > 1 && !isCovered()) {
            return false;
        }
        if (seenCount > 1) {
            isMixed[top * (columns - 1) + left] = true;
        }
        return true;
    }

    /**
     * Whether there is no gap between the surfaces that are seen: they are unbounded, or triangles of which each edge in
     * the cell belongs to two.
     */
    private boolean isCovered() {
        boolean isUnbounded = true;
        for (Surfaces kind : surfaces) {
            for (int n = 0; n < seenCount; n++) {
                if (seen[n] != Rays.NONE && kind instanceof BoundedSurfaces bounded && kind.owns(seen[n])) {
                    isUnbounded = false;
                    if (!isInside(bounded, seen[n] - bounded.surface(0))) {
                        return false;
                    }
                }
            }
        }
        return isUnbounded || isAllOfOneKind();
    }

    /** Whether no edge of a triangle is in the cell, but those that it shares with others that are seen. */
    private boolean isInside(BoundedSurfaces triangles, int k) {
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
        for (int n = 0; n < seenCount; n++) {
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
                for (int n = 1; n < seenCount; n++) {
                    if (!kind.owns(seen[n])) {
                        return false;
                    }
                }
                return true;
            }
        }
        return false;
    }

    private int count(int left, int top, int right, int bottom) {
        int count = 0;
        for (int row = top; row <= bottom; row++) {
            for (int p = row * columns + left; p <= row * columns + right; p++) {
                count += rayOf[p] >= 0 ? 1 : 0;
            }
        }
        return count;
    }

    private boolean isFaint(int left, int top, int right, int bottom) {
        double max = 0;
        for (int corner = 0; corner < RayBundle.CORNERS; corner++) {
            max = Math.max(max, weight[corner(corner, left, top, right, bottom)]);
        }
        return max < tolerance / 2;
    }

    /** Lists the surfaces that are hit; false if they are too many. */
    private boolean findSeen(int left, int top, int right, int bottom) {
        seenCount = 0;
        for (int row = top; row <= bottom; row++) {
            for (int p = row * columns + left; p <= row * columns + right; p++) {
                if (!isSeen(hit[p])) {
                    if (seenCount == MAX_SEEN) {
                        return false;
                    }
                    seen[seenCount++] = hit[p];
                }
            }
        }
        return true;
    }

    private boolean isSeen(int surface) {
        for (int n = 0; n < seenCount; n++) {
            if (seen[n] == surface) {
                return true;
            }
        }
        return false;
    }

    /** An unbounded surface need not be looked for: what shows of one, a corner shows too. */
    private boolean hitsOnlyWhatIsSeen() {
        for (Surfaces kind : surfaces) {
            if (kind instanceof BoundedSurfaces bounded
                    && !BundleSearch.hitsOnly(bounded, bundle, k -> isSeen(bounded.surface(k)), space)) {
                return false;
            }
        }
        return true;
    }

    /** Takes note of which shadow rays matter, before any is found to be occluded. */
    void aimed(int from, int to, ShadowRays all) {
        for (int i = from; i < to; i++) {
            isAimed[i] = all.unoccluded[i];
        }
    }

    /** Proves of the rays from one index to another that the light shines on all of a cell, or on nothing of it. */
    void lit(int from, int to, ShadowRays all, Material ofAll) {
        shadows = all;
        material = ofAll;
        Arrays.fill(rayOf, -1);
        for (int i = from; i < to; i++) {
            int p = rays.pixel[i];
            rayOf[p] = i;
            towardsLight.set(p, all.direction, i);
            lightDistance[p] = all.distance[i];
        }
        prove(this::isLitAlike, 0, 0, columns - 1, rows - 1);
        if (!material.specular().isBlack() && material.shininess() > 1) {
            proveSmooth();
        }
    }

    private boolean isLitAlike(int left, int top, int right, int bottom) {
        int rayCount = count(left, top, right, bottom);
        if (rayCount == 0) {
            return true;
        }
        if (rayCount < (right - left + 1) * (bottom - top + 1) || !findSeen(left, top, right, bottom)) {
            return false;
        }
        if (isFaint(left, top, right, bottom)) {
            return true;
        }
        int aimedCount = 0, seeCount = 0;
        for (int row = top; row <= bottom; row++) {
            for (int p = row * columns + left; p <= row * columns + right; p++) {
                aimedCount += isAimed[rayOf[p]] ? 1 : 0;
                seeCount += shadows.unoccluded[rayOf[p]] ? 1 : 0;
            }
        }
        if (aimedCount == 0) {
            return true;
        }
        if (seeCount == 0) {
            return aimedCount == rayCount && isAllBlocked(left, top, right, bottom);
        }
        return seeCount == aimedCount && isNothingInTheWay(left, top, right, bottom);
    }

    private boolean isNothingInTheWay(int left, int top, int right, int bottom) {
        encloseWaysToLight(left, top, right, bottom);
        return hitsOnlyWhatIsSeen();
    }

    private void encloseWaysToLight(int left, int top, int right, int bottom) {
        bundle.clear();
        for (int row = top; row <= bottom; row++) {
            bundle.include(point, towardsLight, lightDistance, row * columns + left, row * columns + right + 1);
        }
        for (int corner = 0; corner < RayBundle.CORNERS; corner++) {
            int p = corner(corner, left, top, right, bottom);
            Vector at = point.get(p);
            bundle.setCorner(corner, at, towardsLight.get(p), at, normal.get(p));
        }
        bundle.close();
    }

    /** Whether one surface blocks the corners' shadow rays, and so, as all are convex, those between them. */
    private boolean isAllBlocked(int left, int top, int right, int bottom) {
        int[] corners = new int[RayBundle.CORNERS];
        for (int corner = 0; corner < corners.length; corner++) {
            corners[corner] = rayOf[corner(corner, left, top, right, bottom)];
        }
        encloseWaysToLight(left, top, right, bottom);
        for (Surfaces kind : surfaces) {
            if (kind instanceof BoundedSurfaces bounded
                    ? BundleSearch.anyBlocksAll(bounded, bundle, k -> blocksAll(bounded, corners, k), space)
                    : ((UnboundedSurfaces) kind).anyBlocksAll(rays, shadows, corners)) {
                return true;
            }
        }
        return false;
    }

    private boolean blocksAll(BoundedSurfaces bounded, int[] corners, int k) {
        for (int ray : corners) {
            if (!bounded.blocks(rays, shadows, ray, k)) {
                return false;
            }
        }
        return true;
    }

    /** Finds the cells in which the light's highlight is not as smooth as their corners make believe. */
    private void proveSmooth() {
        for (int p = 0; p < columns * rows; p++) {
            if (rayOf[p] >= 0) {
                Vector half = towardsLight.get(p).minus(direction.get(p)).unit();
                chord[p] = half.minus(normal.get(p));
            }
        }
        for (int cell = 0; cell < settled.length; cell++) {
            int p = cell / (columns - 1) * columns + cell % (columns - 1);
            int[] corners = {p, p + 1, p + columns, p + columns + 1};
            settled[cell] &= !isAnyLit(corners) || isSmooth(corners);
        }
    }

    private boolean isAnyLit(int[] corners) {
        boolean isAny = false;
        for (int p : corners) {
            if (rayOf[p] < 0) {
                return false;
            }
            isAny |= shadows.unoccluded[rayOf[p]] && weight[p] >= tolerance / 2;
        }
        return isAny;
    }

    /**
     * Whether the highlight in a cell is smooth. It is the cosine of the angle between normal and half vector, whose chord
     * c is known at the corners, to a power s, about exp(-s c^2 / 2): the mean of the corners is off by its second
     * derivative over 12 at most.
     */
    private boolean isSmooth(int[] corners) {
        double s = material.shininess(), change = 0, min = Double.POSITIVE_INFINITY, max = 0;
        for (int p : corners) {
            min = Math.min(min, chord[p].length());
            max = Math.max(max, chord[p].length());
            change = Math.max(change, chord[p].minus(chord[corners[0]]).length());
        }
        double nearest = Math.max(0, min - change / 2), farthest = max + change / 2;
        double peak = Math.exp(-s * nearest * nearest / 2);
        double bend = Math.min(1, s * Math.max(1, s * farthest * farthest) * change * change / 12);
        Colour specular = material.specular(), light = shadows.light.colour();
        double strength = Math.max(specular.red() * light.red(),
                Math.max(specular.green() * light.green(), specular.blue() * light.blue()));
        return Math.min(1, strength) * peak * bend <= tolerance;
    }

    /** By cell, row by row: whether its corners' mean is its colour, given the samples' colours. */
    boolean[] settled(Samples samples) {
        for (int cell = 0; cell < settled.length; cell++) {
            if (settled[cell]) {
                int p = cell / (columns - 1) * columns + cell % (columns - 1);
                double range = Math.max(range(samples.red, p), Math.max(range(samples.green, p), range(samples.blue, p)));
                settled[cell] = range <= (isMixed[cell] ? 1 : MAX_RANGE) * tolerance;
            }
        }
        return settled;
    }

    private double range(double[] c, int p) {
        double a = c[p], b = c[p + 1], d = c[p + columns], e = c[p + columns + 1];
        return Math.min(1, Math.max(Math.max(a, b), Math.max(d, e)))
                - Math.min(1, Math.min(Math.min(a, b), Math.min(d, e)));
    }
}
