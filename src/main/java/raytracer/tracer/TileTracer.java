package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.rays.BatchObserver;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.search.ClosestHit;
import raytracer.tracer.search.Search;
import raytracer.tracer.search.SearchWorkspace;
import raytracer.tracer.search.Ties;
import raytracer.tracer.settled.SettledCells;
import raytracer.tracer.surface.Surfaces;

/**
 * Traces tiles, one after the other, for one thread. All of a tile's rays take each step together: they find the
 * nearest surface, move there, are shaded, and turn into their mirror images, as often as the depth allows. A ray
 * leaves when it hits nothing or can no longer change its pixel.
 */
public final class TileTracer {

    /**
     * While cold, batches are small, so that methods are compiled for their number of calls and not on-stack
     * (-XX:Tier4MinInvocationThreshold, -XX:Tier4BackEdgeThreshold).
     */
    private static final int COLD_CAPACITY = 40;
    private static final int COLD_RAYS = 5000 * COLD_CAPACITY;

    private final Tracer tracer;
    private final Material[] materials;

    final SearchWorkspace space = new SearchWorkspace();
    final Rays rays = new Rays();
    private final Ties ties;
    private final Search[] closestHit;
    private final ShadingGroups groups;
    private final Shading shading;
    private final int[] kept = new int[Batch.CAPACITY];

    /** How many surfaces the paths of this round's rays have hit with the one that they hit now. */
    private int depth;

    private final SettledCells cells;
    /** Null if nobody looks on. */
    private BatchObserver observer;

    /** What is being traced: rays know their sample's number as their pixel. */
    private Samples samples;

    private long primaryCount;
    private long reflectionCount;

    TileTracer(Tracer tracer) {
        this.tracer = tracer;
        List<Surfaces> surfaces = tracer.surfaces();
        materials = tracer.table().materials();
        ties = new Ties(tracer.table().declared(), surfaces, rays, space.surfaces());
        groups = new ShadingGroups(tracer.table());
        closestHit = surfaces.stream().map(kind -> ClosestHit.among(kind, rays, space)).toArray(Search[]::new);
        shading = new Shading(surfaces, tracer.lights(), rays, space);
        cells = new SettledCells(surfaces, rays, space);
    }

    /** Traces the rays through all of these points, and sets their colours. */
    public void trace(Samples all) {
        samples = all;
        int max = tracer.traced().get() < COLD_RAYS ? COLD_CAPACITY : Batch.CAPACITY;
        for (int from = 0; from < all.count; from += max) {
            trace(from, Math.min(from + max, all.count));
        }
    }

    /**
     * Traces the rays through the corners of a rectangle's pixels, one more of each than there are columns and rows,
     * and sets their colours.
     *
     * @param tolerance by how much a pixel's colour may be off without more samples, of a range of [0, 1]
     * @return by pixel, row by row: whether it is proved that its corners' mean is its colour
     */
    public boolean[] traceCorners(int left, int top, int columns, int rows, double tolerance, Samples all) {
        all.setCorners(left, top, columns, rows);
        cells.start(columns + 1, rows + 1, tolerance);
        trace(all, cells);
        return cells.settled(all);
    }

    /** Traces the rays through all of these points together, while somebody looks on. */
    void trace(Samples all, BatchObserver onlooker) {
        samples = all;
        observer = onlooker;
        trace(0, all.count);
        observer = null;
    }

    /** Traces the rays through the centres of a tile's pixels, which become the points, and sets their colours. */
    public void traceCentres(int left, int top, int columns, int rows, Samples all) {
        all.setCentres(left, top, columns, rows);
        trace(all);
    }

    private void trace(int from, int to) {
        start(from, to);
        depth = 1;
        while (rays.count > 0) {
            tracer.traced().addAndGet(rays.count);
            findClosestHits();
            groups.arrange(rays);
            moveToHits();
            shade();
            addToSamples();
            reflect();
        }
    }

    private void start(int from, int to) {
        Arrays.fill(samples.red, from, to, 0);
        Arrays.fill(samples.green, from, to, 0);
        Arrays.fill(samples.blue, from, to, 0);
        rays.start(from, to - from);
        tracer.pinhole().aim(rays, samples);
        primaryCount += to - from;
    }

    /** What this has traced since it was made. */
    public RayCounts counts() {
        return new RayCounts(primaryCount, shading.shadowCount(), reflectionCount);
    }

    /** Finds every ray's nearest surface. */
    private void findClosestHits() {
        rays.clearHits();
        for (Search kind : closestHit) {
            kind.run(0, rays.count);
        }
        ties.settle();
        if (observer != null) {
            observer.found();
        }
    }

    /** Takes every ray there, and notes what it has hit. */
    private void moveToHits() {
        for (int group = 0; group < groups.count; group++) {
            int first = groups.start[group];
            kindOf(rays.hit[first]).moveToHits(rays, first, groups.start[group + 1]);
        }
        if (observer != null) {
            observer.moved();
        }
    }

    private Surfaces kindOf(int surface) {
        int kind = 0;
        while (!tracer.surfaces().get(kind).owns(surface)) {
            kind++;
        }
        return tracer.surfaces().get(kind);
    }

    private void shade() {
        for (int group = 0; group < groups.count; group++) {
            shading.shade(groups.start[group], groups.start[group + 1], materials[groups.material[group]], observer);
        }
    }

    private void addToSamples() {
        for (int i = 0; i < rays.count; i++) {
            int p = rays.pixel[i];
            samples.red[p] += times(rays.red[i], shading.red[i]);
            samples.green[p] += times(rays.green[i], shading.green[i]);
            samples.blue[p] += times(rays.blue[i], shading.blue[i]);
        }
    }

    /** Turns every ray into its mirror image; those that may go no deeper, or change their pixel no more, leave. */
    private void reflect() {
        if (depth++ == tracer.maxDepth()) {
            rays.count = 0;
            return;
        }
        int count = 0;
        for (int group = 0; group < groups.count; group++) {
            Colour mirror = materials[groups.material[group]].specular();
            if (!mirror.isBlack()) {
                count = dim(groups.start[group], groups.start[group + 1], mirror, count);
            }
        }
        rays.leaveEye = false;
        if (count < rays.count) {
            rays.selectArrived(kept, count);
        }
        rays.mirror();
        reflectionCount += count;
    }

    /** Takes a mirror's share of light from rays, and keeps those that are worth following; returns how many are. */
    private int dim(int from, int to, Colour mirror, int keptBefore) {
        int count = keptBefore;
        for (int i = from; i < to; i++) {
            rays.red[i] = times(rays.red[i], mirror.red());
            rays.green[i] = times(rays.green[i], mirror.green());
            rays.blue[i] = times(rays.blue[i], mirror.blue());
            if (canChange(i)) {
                kept[count++] = i;
            }
        }
        return count;
    }

    private boolean canChange(int i) {
        int p = rays.pixel[i];
        return rays.red[i] > 0 && samples.red[p] < 1 || rays.green[i] > 0 && samples.green[p] < 1
                || rays.blue[i] > 0 && samples.blue[p] < 1;
    }

    /** A product in which nothing of something infinite is nothing: an infinite highlight, a black component. */
    private static double times(double a, double b) {
        return a == 0 || b == 0 ? 0 : a * b;
    }
}
