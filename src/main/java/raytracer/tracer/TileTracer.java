package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.search.ClosestHit;
import raytracer.tracer.search.Search;
import raytracer.tracer.search.Ties;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

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
    private static final int COLD_RAYS = 200_000;

    private final Tracer tracer;
    private final Material[] materials;
    private final FaintestWeight faintest;
    private final Pinhole pinhole;

    final Workspace workspace = new Workspace();
    final Rays rays = new Rays();
    private final Ties ties;
    private final Search[] closestHit;
    private final ShadingGroups groups;
    private final Shading shading;

    /**
     * What rays do until none is left. HotSpot inlines no call whose receiver it cannot tell, so it compiles each step alone:
     * in one method, C2 works 200 ms longer before any of them is fast.
     */
    private final Runnable[] steps = {
        this::findClosestHits, this::moveToHits, this::shade, this::addToSamples, this::reflect
    };
    private final int[] kept = new int[Batch.CAPACITY];

    /** How many surfaces the paths of this round's rays have hit with the one that they hit now. */
    private int depth;

    /** What is being traced: rays know the numbers of their samples. */
    private Samples samples;

    private long primaryCount;
    private long reflectionCount;

    TileTracer(Tracer tracer) {
        this.tracer = tracer;
        List<Surfaces> surfaces = tracer.surfaces();
        materials = tracer.table().materials();
        faintest = FaintestWeight.of(tracer.lights(), materials, tracer.scene().maxDepth());
        ties = new Ties(tracer.table().declared(), surfaces, rays, workspace);
        groups = new ShadingGroups(tracer.table());
        closestHit = surfaces.stream().map(kind -> ClosestHit.among(kind, rays, workspace)).toArray(Search[]::new);
        pinhole = new Pinhole(tracer.scene());
        shading = new Shading(tracer, tracer.lights(), rays, workspace);
    }

    /** Traces the rays through all of these points, and sets their colours. */
    public void trace(Samples all) {
        int max = tracer.traced().get() < COLD_RAYS ? COLD_CAPACITY : Batch.CAPACITY;
        for (int from = 0; from < all.count(); from += max) {
            trace(all, from, Math.min(from + max, all.count()));
        }
    }

    /** Traces the rays through the centres of a tile's pixels, which become the points, and sets their colours. */
    public void traceCentres(int left, int top, int columns, int rows, Samples all) {
        all.setCentres(left, top, columns, rows);
        trace(all);
    }

    private void trace(Samples all, int from, int to) {
        start(all, from, to);
        while (rays.count > 0) {
            for (Runnable step : steps) {
                step.run();
            }
        }
    }

    /** Makes the rays through these points, from one index to another. */
    void start(Samples all, int from, int to) {
        samples = all;
        depth = 1;
        Arrays.fill(samples.red, from, to, 0);
        Arrays.fill(samples.green, from, to, 0);
        Arrays.fill(samples.blue, from, to, 0);
        rays.start(from, to - from);
        pinhole.aim(rays, samples, from);
        primaryCount += to - from;
    }

    /** What this has traced since it was made. */
    public RayCounts counts() {
        return new RayCounts(primaryCount, shading.shadowCount(), reflectionCount);
    }

    /** Finds every ray's nearest surface. */
    void findClosestHits() {
        tracer.traced().addAndGet(rays.count);
        rays.clearHits();
        for (Search kind : closestHit) {
            kind.run(0, rays.count);
        }
        ties.settle();
    }

    /** Takes every ray there, those together that have hit the same material; those that have hit nothing leave. */
    void moveToHits() {
        groups.arrange(rays);
        for (int group = 0; group < groups.count; group++) {
            int first = groups.start[group];
            kindOf(rays.hit[first]).moveToHits(rays, first, groups.start[group + 1], workspace);
        }
    }

    private Surfaces kindOf(int surface) {
        int kind = 0;
        while (!tracer.surfaces().get(kind).owns(surface)) {
            kind++;
        }
        return tracer.surfaces().get(kind);
    }

    void shade() {
        for (int group = 0; group < groups.count; group++) {
            shading.shade(groups.start[group], groups.start[group + 1], materials[groups.material[group]]);
        }
    }

    // A method of its own, which HotSpot compiles long before shading: in one with that, 16 samples of planet took 1.18.
    void addToSamples() {
        if (rays.leaveEye) {
            for (int i = 0; i < rays.count; i++) {
                int p = rays.sample[i];
                samples.red[p] = shading.red[i];
                samples.green[p] = shading.green[i];
                samples.blue[p] = shading.blue[i];
            }
            return;
        }
        for (int i = 0; i < rays.count; i++) {
            int p = rays.sample[i];
            samples.red[p] += times(rays.red[i], shading.red[i]);
            samples.green[p] += times(rays.green[i], shading.green[i]);
            samples.blue[p] += times(rays.blue[i], shading.blue[i]);
        }
    }

    /** Turns every ray into its mirror image; those that may go no deeper, or change their pixel no more, leave. */
    void reflect() {
        if (depth++ == tracer.scene().maxDepth()) {
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
        int p = rays.sample[i];
        return faintest.canChange(rays.red[i], samples.red[p], rays.green[i], samples.green[p], rays.blue[i],
                samples.blue[p]);
    }

    /** A product in which nothing of something infinite is nothing: an infinite highlight, a black component. */
    private static double times(double a, double b) {
        return a == 0 || b == 0 ? 0 : a * b;
    }
}
