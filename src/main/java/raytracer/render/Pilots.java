package raytracer.render;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;
import raytracer.tracer.rays.Samples;

/**
 * Pixels in every tile of a picture that tell how many samples it takes: by how much samples differ there, and by how
 * much few are off, as four times as many show. They are of the whole picture, so that a part of it gets the same
 * samples.
 */
final class Pilots {

    /** Of a whole tile. The first round takes as long as so many samples of each pixel. */
    private static final int PER_TILE = 16;
    private static final double FIRST_ROUND = 0.9;

    /** Samples of a pilot in the first round, before it gets four times as many. */
    private static final int FEW = 4;

    /** There is a next round if it takes less than this part of what the picture does. */
    private static final double MAX_PART = 0.1;
    private static final int MAX_ROUNDS = 2;

    /** Of a huge picture, only so many tiles have pilots. */
    private static final int MAX_TILES = 4096;

    /** Of so many tiles that have pilots, one tells which part of the picture is settled. */
    private static final int TILES_PER_PROOF = 8;

    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    private final Tracer tracer;
    private final double error;
    private final Tiles tiles;
    private final int stride;
    private final SampleBudget.Pilot[][] byTile;
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicInteger nextProof = new AtomicInteger();
    private final AtomicLong provedPixels = new AtomicLong();
    private final AtomicLong unsettledPixels = new AtomicLong();
    private int round = -1;

    Pilots(Tracer tracer, double error) {
        this.tracer = tracer;
        this.error = error;
        tiles = new Tiles(Region.whole(tracer.width(), tracer.height()), AdaptiveSampler.TILE_SIDE);
        stride = (int) ((tiles.count() + MAX_TILES - 1) / MAX_TILES);
        byTile = new SampleBudget.Pilot[(int) ((tiles.count() + stride - 1) / stride)][];
    }

    /** The first round, or one in which the same pilots get four times as many samples as in the last. */
    void startRound() {
        round++;
        next.set(0);
    }

    /** Whether the budget takes so long that it is worth while to know more. */
    boolean areCoarse(SampleBudget budget) {
        return round + 1 < MAX_ROUNDS && FIRST_ROUND * Math.pow(4, round + 1) / stride < MAX_PART * budget.cost();
    }

    private int few() {
        return FEW << 2 * round;
    }

    /** Samples pilots of tiles that no other thread has taken. */
    RayCounts sample() {
        TileTracer mine = tracer.newTileTracer();
        SampleQueue queue = new SampleQueue(mine);
        for (int i; (i = next.getAndIncrement()) < byTile.length; ) {
            byTile[i] = sample(i, queue);
        }
        return mine.counts();
    }

    /** The tile that pilots i are in. */
    private Region tile(int i) {
        return tiles.get((long) i * stride);
    }

    private SampleBudget.Pilot[] sample(int ofTile, SampleQueue queue) {
        int count = Math.max(1, PER_TILE * tile(ofTile).pixels() / AdaptiveSampler.TILE_PIXELS);
        PixelMeans coarse = means(ofTile, count, few(), queue), fine = means(ofTile, count, 4 * few(), queue);
        SampleBudget.Pilot[] pilots = new SampleBudget.Pilot[count];
        Arrays.setAll(pilots, i -> new SampleBudget.Pilot(
                coarse.variance(i), fine.variance(i), fine.squaredDifference(coarse, i)));
        return pilots;
    }

    private PixelMeans means(int ofTile, int count, int samples, SampleQueue queue) {
        Region tile = tile(ofTile);
        long number = (long) ofTile * stride;
        PixelMeans means = new PixelMeans(count);
        queue.start(means);
        for (int i = 0; i < count; i++) {
            // A lattice, and not the same one in each tile, as pictures may be regular.
            double x = number * Math.sqrt(2) + (i + 0.5) / count, y = (number + i) * GOLDEN;
            queue.add(i, tile.x() + (int) (tile.width() * (x - Math.floor(x))),
                    tile.y() + (int) (tile.height() * (y - Math.floor(y))), samples, 0);
        }
        queue.flush();
        return means;
    }

    /** Proves pixels settled, of tiles that no other thread has taken. */
    RayCounts prove() {
        TileTracer mine = tracer.newTileTracer();
        Samples corners = new Samples();
        for (int i; (i = nextProof.getAndAdd(TILES_PER_PROOF)) < byTile.length; ) {
            Region tile = tile(i);
            for (boolean isSettled : mine.traceCorners(
                    tile.x(), tile.y(), tile.width(), tile.height(), error, corners)) {
                provedPixels.incrementAndGet();
                unsettledPixels.addAndGet(isSettled ? 0 : 1);
            }
        }
        return mine.counts();
    }

    /** What the picture takes, as far as that is known. */
    SampleBudget budget() {
        List<SampleBudget.Pilot> all = Arrays.stream(byTile).flatMap(Arrays::stream).toList();
        return SampleBudget.plan(all, few(), (double) unsettledPixels.get() / Math.max(1, provedPixels.get()), error);
    }
}
