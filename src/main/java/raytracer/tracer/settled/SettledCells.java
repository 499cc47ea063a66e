package raytracer.tracer.settled;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Material;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.BatchObserver;
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
 * Proves of the cells of a grid of samples that there is nothing in them but what their corners show: no other
 * surface in front, no edge of a shadow, and so on along mirrors, as far as their light can change a pixel (Genetti,
 * Gordon and Williams, Adaptive Supersampling in Object Space Using Pyramidal Rays, 1998). It watches a batch being
 * traced. What is proved of a rectangle of cells is proved of each; where that fails, its halves are tried, down to
 * single cells.
 */
public final class SettledCells implements BatchObserver {

    /** By how many times the tolerance the colours of a cell's corners may differ. */
    private static final double MAX_RANGE = 16;

    /** In place of a surface's index: not all rays hit the same. */
    private static final int SEVERAL = -2;

    private final List<Surfaces> surfaces;
    private final Rays rays;
    private final SearchWorkspace space;
    private final RayBundle bundle = new RayBundle();

    private CornerGrid grid;
    private double tolerance;

    // By corner, row by row: its ray before that moved to its hit, and the hit.
    private final Vectors origin = new Vectors();
    private final Vectors direction = new Vectors();
    private final double[] distance = new double[Batch.CAPACITY];
    private final int[] hit = new int[Batch.CAPACITY];
    private final double[] weight = new double[Batch.CAPACITY];
    private final Vectors point = new Vectors();
    private final Vectors normal = new Vectors();
    private final boolean[] isAimed = new boolean[Batch.CAPACITY];

    private final Highlight highlight = new Highlight();

    // Of the shadow rays to the current light.
    private final Vectors towardsLight = new Vectors();
    private final double[] lightDistance = new double[Batch.CAPACITY];
    private ShadowRays shadows;
    private Material material;

    public SettledCells(List<Surfaces> surfaces, Rays rays, SearchWorkspace space) {
        this.surfaces = surfaces;
        this.rays = rays;
        this.space = space;
    }

    /** @param tolerance by how much a pixel's colour may be off without more samples, of a range of [0, 1] */
    public void start(int columns, int rows, double tolerance) {
        grid = new CornerGrid(columns, rows);
        this.tolerance = tolerance;
    }

    /** Takes note of all rays. */
    @Override
    public void found() {
        Arrays.fill(grid.rayOf, -1);
        for (int i = 0; i < rays.count; i++) {
            int p = rays.pixel[i];
            grid.rayOf[p] = i;
            origin.set(p, rays.origin, i);
            direction.set(p, rays.direction, i);
            distance[p] = rays.distance[i];
            hit[p] = rays.hit[i];
            weight[p] = rays.leaveEye ? 1 : Math.max(rays.red[i], Math.max(rays.green[i], rays.blue[i]));
        }
    }

    /** Takes note of where the rays are now, and proves that nothing else is in front of that. */
    @Override
    public void moved() {
        for (int i = 0; i < rays.count; i++) {
            int p = rays.pixel[i];
            point.set(p, rays.origin, i);
            normal.set(p, rays.normal, i);
        }
        grid.prove(this::showsWhatItsCornersShow);
    }

    private boolean showsWhatItsCornersShow(int left, int top, int right, int bottom) {
        int rayCount = grid.count(left, top, right, bottom);
        if (rayCount == 0) {
            return true;
        }
        if (rayCount < (right - left + 1) * (bottom - top + 1)) {
            return false;
        }
        if (isFaint(left, top, right, bottom)) {
            return true;
        }
        int seen = surfaceSeen(left, top, right, bottom);
        if (seen == SEVERAL) {
            return false;
        }
        bundle.clear();
        for (int row = top; row <= bottom; row++) {
            bundle.include(origin, direction, distance, row * grid.columns + left, row * grid.columns + right + 1);
        }
        for (int corner = 0; corner < RayBundle.CORNERS; corner++) {
            int p = grid.corner(corner, left, top, right, bottom);
            Vector at = seen == Rays.NONE ? null : point.get(p);
            bundle.setCorner(corner, origin.get(p), direction.get(p), at, normal.get(p));
        }
        bundle.close();
        return hitsOnly(seen);
    }

    private boolean isFaint(int left, int top, int right, int bottom) {
        double max = 0;
        for (int corner = 0; corner < RayBundle.CORNERS; corner++) {
            max = Math.max(max, weight[grid.corner(corner, left, top, right, bottom)]);
        }
        return max < tolerance / 2;
    }

    /** The surface that all rays hit, or {@link Rays#NONE} or {@link #SEVERAL}. */
    private int surfaceSeen(int left, int top, int right, int bottom) {
        int seen = hit[top * grid.columns + left];
        for (int row = top; row <= bottom; row++) {
            for (int p = row * grid.columns + left; p <= row * grid.columns + right; p++) {
                if (hit[p] != seen) {
                    return SEVERAL;
                }
            }
        }
        return seen;
    }

    /** An unbounded surface need not be looked for: what shows of one, a corner shows too. */
    private boolean hitsOnly(int seen) {
        for (Surfaces kind : surfaces) {
            if (kind instanceof BoundedSurfaces bounded
                    && !BundleSearch.hitsNone(bounded, bundle, seen, space)) {
                return false;
            }
        }
        return true;
    }

    /** Takes note of which shadow rays matter. */
    @Override
    public void aimed(int from, int to, ShadowRays all) {
        for (int i = from; i < to; i++) {
            isAimed[i] = all.unoccluded[i];
        }
    }

    /** Proves that the light shines on all of a cell, or on nothing of it. */
    @Override
    public void lit(int from, int to, ShadowRays all, Material ofAll) {
        shadows = all;
        material = ofAll;
        Arrays.fill(grid.rayOf, -1);
        for (int i = from; i < to; i++) {
            int p = rays.pixel[i];
            grid.rayOf[p] = i;
            towardsLight.set(p, all.direction, i);
            lightDistance[p] = all.distance[i];
        }
        grid.prove(this::isLitAlike);
        if (!material.specular().isBlack() && material.shininess() > 1) {
            proveSmooth();
        }
    }

    private boolean isLitAlike(int left, int top, int right, int bottom) {
        int rayCount = grid.count(left, top, right, bottom);
        if (rayCount == 0) {
            return true;
        }
        if (rayCount < (right - left + 1) * (bottom - top + 1)) {
            return false;
        }
        if (isFaint(left, top, right, bottom)) {
            return true;
        }
        int seen = surfaceSeen(left, top, right, bottom);
        if (seen == SEVERAL) {
            return false;
        }
        int aimedCount = 0, seeCount = 0;
        for (int row = top; row <= bottom; row++) {
            for (int p = row * grid.columns + left; p <= row * grid.columns + right; p++) {
                aimedCount += isAimed[grid.rayOf[p]] ? 1 : 0;
                seeCount += shadows.unoccluded[grid.rayOf[p]] ? 1 : 0;
            }
        }
        if (aimedCount == 0) {
            return true;
        }
        if (seeCount == 0) {
            return aimedCount == rayCount && isAllBlocked(left, top, right, bottom);
        }
        encloseWaysToLight(left, top, right, bottom);
        return seeCount == aimedCount && hitsOnly(seen);
    }

    private void encloseWaysToLight(int left, int top, int right, int bottom) {
        bundle.clear();
        for (int row = top; row <= bottom; row++) {
            bundle.include(point, towardsLight, lightDistance, row * grid.columns + left, row * grid.columns + right + 1);
        }
        for (int corner = 0; corner < RayBundle.CORNERS; corner++) {
            int p = grid.corner(corner, left, top, right, bottom);
            Vector at = point.get(p);
            bundle.setCorner(corner, at, towardsLight.get(p), at, normal.get(p));
        }
        bundle.close();
    }

    /** Whether one surface blocks the corners' shadow rays, and so, as all are convex, those between them. */
    private boolean isAllBlocked(int left, int top, int right, int bottom) {
        int[] corners = new int[RayBundle.CORNERS];
        for (int corner = 0; corner < corners.length; corner++) {
            corners[corner] = grid.rayOf[grid.corner(corner, left, top, right, bottom)];
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

    /** Finds the cells in which the highlight may differ from the mean of their corners. */
    private void proveSmooth() {
        for (int p = 0; p < grid.columns * grid.rows; p++) {
            if (grid.rayOf[p] >= 0) {
                highlight.set(p, towardsLight, direction, normal);
            }
        }
        for (int cell = 0; cell < grid.settled.length; cell++) {
            int p = grid.point(cell);
            int[] corners = {p, p + 1, p + grid.columns, p + grid.columns + 1};
            grid.settled[cell] &= !isAnyLit(corners)
                    || highlight.isSmooth(corners, material, shadows.light.colour(), tolerance);
        }
    }

    private boolean isAnyLit(int[] corners) {
        boolean isAny = false;
        for (int p : corners) {
            if (grid.rayOf[p] < 0) {
                return false;
            }
            isAny |= shadows.unoccluded[grid.rayOf[p]] && weight[p] >= tolerance / 2;
        }
        return isAny;
    }

    /** By cell, row by row: whether its corners' mean is its colour, given the samples' colours. */
    public boolean[] settled(Samples samples) {
        for (int cell = 0; cell < grid.settled.length; cell++) {
            if (grid.settled[cell]) {
                int p = grid.point(cell);
                double range = Math.max(range(samples.red, p), Math.max(range(samples.green, p), range(samples.blue, p)));
                grid.settled[cell] = range <= MAX_RANGE * tolerance;
            }
        }
        return grid.settled;
    }

    private double range(double[] c, int p) {
        double a = c[p], b = c[p + 1], d = c[p + grid.columns], e = c[p + grid.columns + 1];
        return Math.min(1, Math.max(Math.max(a, b), Math.max(d, e)))
                - Math.min(1, Math.min(Math.min(a, b), Math.min(d, e)));
    }
}
