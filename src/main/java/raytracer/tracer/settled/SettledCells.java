package raytracer.tracer.settled;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Material;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.BatchObserver;
import raytracer.tracer.rays.RayBundle;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.BundleSearch;
import raytracer.tracer.search.SearchWorkspace;
import raytracer.tracer.surface.Surfaces;

/**
 * Proves of the cells of a grid of samples that there is nothing in them but what their corners show: no other
 * surface in front, no edge of a shadow, and so on along mirrors, as far as their light can change a pixel (Genetti,
 * Gordon and Williams, Adaptive Supersampling in Object Space Using Pyramidal Rays, 1998). It watches a batch being
 * traced.
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
            weight[p] = Math.max(rays.red[i], Math.max(rays.green[i], rays.blue[i]));
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
        prove((cells, seen) -> {
            enclose(cells, origin, direction, distance, seen);
            return showsOnly(seen);
        });
    }

    /** A claim of cells in which all rays hit the same surface, or nothing. */
    private interface Claim {
        boolean holds(CornerGrid.Cells cells, int seen);
    }

    /** Proves a claim of cells that have a ray at each corner; it need not hold where no ray or no light comes. */
    private void prove(Claim claim) {
        grid.prove(cells -> {
            int rayCount = grid.rayCount(cells);
            if (rayCount == 0 || rayCount < cells.cornerCount()) {
                return rayCount == 0;
            }
            int seen = surfaceSeen(cells);
            return isFaint(cells) || seen != SEVERAL && claim.holds(cells, seen);
        });
    }

    private boolean isFaint(CornerGrid.Cells cells) {
        double max = 0;
        for (int p : grid.outermost(cells)) {
            max = Math.max(max, weight[p]);
        }
        return max < tolerance / 2;
    }

    /** The surface that all rays hit, or {@link Rays#NONE} or {@link #SEVERAL}. */
    private int surfaceSeen(CornerGrid.Cells cells) {
        int seen = hit[grid.corner(cells.left(), cells.top())];
        for (int row = cells.top(); row <= cells.bottom(); row++) {
            for (int p = grid.corner(cells.left(), row); p <= grid.corner(cells.right(), row); p++) {
                if (hit[p] != seen) {
                    return SEVERAL;
                }
            }
        }
        return seen;
    }

    /** Makes the bundle of all rays through cells, or from them to the light. */
    private void enclose(CornerGrid.Cells cells, Vectors from, Vectors unit, double[] length, int seen) {
        bundle.intervals().clear();
        for (int row = cells.top(); row <= cells.bottom(); row++) {
            bundle.intervals().include(from, unit, length, grid.corner(cells.left(), row), grid.corner(cells.right(), row) + 1);
        }
        int[] outermost = grid.outermost(cells);
        for (int corner = 0; corner < outermost.length; corner++) {
            int p = outermost[corner];
            bundle.setCorner(corner, from.get(p), unit.get(p), seen == Rays.NONE ? null : point.get(p), normal.get(p));
        }
        bundle.close();
    }

    private boolean showsOnly(int seen) {
        return surfaces.stream().allMatch(kind -> BundleSearch.showsNone(kind, bundle, seen, space));
    }

    /** Takes note of which shadow rays matter. */
    @Override
    public void aimed(int from, int to, ShadowRays all) {
        System.arraycopy(all.unoccluded, from, isAimed, from, to - from);
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
        prove(this::isLitAlike);
        if (!material.specular().isBlack() && material.shininess() > 1) {
            proveSmooth();
        }
    }

    private boolean isLitAlike(CornerGrid.Cells cells, int seen) {
        int aimed = 0, unoccluded = 0;
        for (int row = cells.top(); row <= cells.bottom(); row++) {
            for (int p = grid.corner(cells.left(), row); p <= grid.corner(cells.right(), row); p++) {
                aimed += isAimed[grid.rayOf[p]] ? 1 : 0;
                unoccluded += shadows.unoccluded[grid.rayOf[p]] ? 1 : 0;
            }
        }
        if (aimed == 0) {
            return true;
        }
        enclose(cells, point, towardsLight, lightDistance, seen);
        return unoccluded == 0 ? aimed == cells.cornerCount() && isAllBlocked(cells)
                : unoccluded == aimed && showsOnly(seen);
    }

    /** Whether one surface blocks the corners' shadow rays, and so, as all are convex, those between them. */
    private boolean isAllBlocked(CornerGrid.Cells cells) {
        int[] corners = Arrays.stream(grid.outermost(cells)).map(p -> grid.rayOf[p]).toArray();
        return surfaces.stream().anyMatch(kind -> BundleSearch.anyBlocksAll(kind, bundle,
                k -> Arrays.stream(corners).allMatch(ray -> kind.blocks(rays, shadows, ray, k)), space));
    }

    /** Finds the cells in which the highlight may differ from the mean of their corners. */
    private void proveSmooth() {
        for (int p = 0; p < grid.columns * grid.rows; p++) {
            if (grid.rayOf[p] >= 0) {
                highlight.set(p, towardsLight, direction, normal);
            }
        }
        for (int cell = 0; cell < grid.settled.length; cell++) {
            int[] corners = grid.cornersOf(cell);
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
                int[] corners = grid.cornersOf(cell);
                double range = Math.max(range(samples.red, corners),
                        Math.max(range(samples.green, corners), range(samples.blue, corners)));
                grid.settled[cell] = range <= MAX_RANGE * tolerance;
            }
        }
        return grid.settled;
    }

    private static double range(double[] c, int[] corners) {
        double min = 1, max = 0;
        for (int p : corners) {
            min = Math.min(min, c[p]);
            max = Math.max(max, Math.min(1, c[p]));
        }
        return max - min;
    }
}
