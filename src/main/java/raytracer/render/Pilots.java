package raytracer.render;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import raytracer.tracer.RayCounts;
import raytracer.tracer.TileTracer;
import raytracer.tracer.Tracer;

/**
 * Pixels in every tile of a picture that tell how many samples it takes: by how much samples differ there, and by how
 * much few are off, as four times as many show. They are of the whole picture, so that a part of it gets the same
 * samples.
 */
final class Pilots {

    /** Of a whole tile, but for small pictures, in which so few would tell little. */
    private static final int PER_TILE = 18;
    private static final int MIN_COUNT = 2000;

    /** Samples of a pilot in the first round, before it gets four times as many. */
    private static final int FEW = 4;

    /** There is a next round if it takes less than this part of what the picture does. */
    private static final double MAX_PART = 0.1;
    private static final int MAX_ROUNDS = 2;

    /** Of a huge picture, only so many tiles have pilots. */
    private static final int MAX_TILES = 4096;

    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    private final Tracer tracer;
    private final double error;
    private final Tiles tiles;
    private final int stride;
    private final int perTile;
    private final SampleBudget.Pilot[][] byTile;
    private final AtomicInteger next = new AtomicInteger();
    private int round = -1;

    /** @param error that is aimed at */
    Pilots(Tracer tracer, double error) {
        this.tracer = tracer;
        this.error = error;
        tiles = Tiles.of(Region.whole(tracer.width(), tracer.height()));
        stride = (int) ((tiles.count() + MAX_TILES - 1) / MAX_TILES);
        perTile = (int) Math.min(Tiles.CAPACITY, Math.max(PER_TILE, MIN_COUNT / tiles.count()));
        byTile = new SampleBudget.Pilot[(int) ((tiles.count() + stride - 1) / stride)][];
    }

    /** The first round, or one in which the same pilots get four times as many samples as in the last. */
    void startRound() {
        round++;
        next.set(0);
    }

    /** Whether so many samples of every pixel take so long that it is worth while to know more. */
    boolean areCoarse(int samples) {
        // Four and sixteen times as many samples of each pilot as few, spread over all pixels.
        double next = 20.0 * few() * perTile / Tiles.CAPACITY / stride;
        return round + 1 < MAX_ROUNDS && next < MAX_PART * samples;
    }

    private int few() {
        return FEW << 2 * round;
    }

    /** Samples pilots of tiles that no other thread has taken. */
    RayCounts sample() {
        TileTracer mine = tracer.newTileTracer();
        SampleQueue queue = new SampleQueue(mine, true);
        for (int i; (i = next.getAndIncrement()) < byTile.length; ) {
            byTile[i] = sample((long) i * stride, queue);
        }
        return mine.counts();
    }

    private SampleBudget.Pilot[] sample(long tile, SampleQueue queue) {
        int count = Math.max(1, perTile * tiles.get(tile).pixels() / Tiles.CAPACITY);
        PixelMeans coarse = means(tile, count, few(), queue), fine = means(tile, count, 4 * few(), queue);
        SampleBudget.Pilot[] pilots = new SampleBudget.Pilot[count];
        Arrays.setAll(pilots, i -> new SampleBudget.Pilot(
                coarse.variance(i), fine.variance(i), fine.squaredDifference(coarse, i)));
        return pilots;
    }

    private PixelMeans means(long number, int count, int samples, SampleQueue queue) {
        Region tile = tiles.get(number);
        PixelMeans means = new PixelMeans(count);
        queue.start(means);
        Pattern pattern = Pattern.lattice(samples, 0);
        for (int i = 0; i < count; i++) {
            // A lattice, and not the same one in each tile, as pictures may be regular.
            double x = number * Math.sqrt(2) + (i + 0.5) / count, y = (number + i) * GOLDEN;
            queue.add(i, pattern, tile.x() + (int) (tile.width() * (x - Math.floor(x))),
                    tile.y() + (int) (tile.height() * (y - Math.floor(y))));
        }
        queue.flush();
        return means;
    }

    /** How many samples every pixel gets, as far as that is known. */
    int samples() {
        return SampleBudget.plan(Arrays.stream(byTile).flatMap(Arrays::stream).toList(), few(), error);
    }
}
