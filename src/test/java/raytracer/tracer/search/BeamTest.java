package raytracer.tracer.search;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Colour;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhTest;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.RayIntervals;
import raytracer.tracer.rays.Rays;

/** A beam. */
class BeamTest {

    private static final int RAYS = 40;

    private final Beam beam = new Beam();
    private final RayIntervals intervals = new RayIntervals();
    private final Rays rays = new Rays();
    private final double[][] o = {rays.ox, rays.oy, rays.oz};
    private final double[][] d = {rays.dx, rays.dy, rays.dz};
    private final double[] distance = rays.distance;

    private void set(int ray, Vector origin, Vector direction, double far) {
        o[0][ray] = origin.x();
        o[1][ray] = origin.y();
        o[2][ray] = origin.z();
        d[0][ray] = direction.x();
        d[1][ray] = direction.y();
        d[2][ray] = direction.z();
        distance[ray] = far;
    }

    private boolean gather(Bvh bvh) {
        intervals.enclose(rays, 0, RAYS);
        return beam.gather(intervals, bvh, 24);
    }

    private BitSet gathered(Bvh bvh) {
        BitSet things = new BitSet();
        for (int i = 0; i < beam.count; i++) {
            things.set(bvh.order()[beam.primitives[i]]);
        }
        for (int k = 0; k < bvh.oversized(); k++) {
            things.set(bvh.order()[k]);
        }
        return things;
    }

    @ParameterizedTest(name = "holds all that its rays meet: world offset {0}, origins {1} apart, directions {2} apart")
    @CsvSource({"0, 0, .01", "0, .02, .005", "0, .02, 0", "1e6, .01, .01", "-1e9, .01, .01", "0, .5, .3"})
    void holdsAllThatItsRaysMeet(double offset, double apart, double spread) {
        double[][] boxes = BvhTest.cubes(300, 2, .04, offset, 1);
        Bvh bvh = BvhTest.build(boxes);
        Random random = new Random(2);
        int met = 0, wide = 0;
        for (int tile = 0; tile < 800; tile++) {
            Vector axis = tile % 4 == 0 ? new Vector(0, tile % 8 == 0 ? 1 : -1, 0)
                    : new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector start = new Vector(offset - 3 * axis.x() + random.nextDouble() - .5,
                    offset - 3 * axis.y() + random.nextDouble() - .5, offset - 3 * axis.z() + random.nextDouble() - .5);
            for (int i = 0; i < RAYS; i++) {
                Vector from = new Vector(start.x() + apart * random.nextDouble(), start.y() + apart * random.nextDouble(),
                        start.z() + apart * random.nextDouble());
                set(i, from, new Vector(axis.x() + spread * random.nextGaussian(), axis.y() + spread * random.nextGaussian(),
                        axis.z() + spread * random.nextGaussian()).unit(), i % 2 == 0 ? 2.5 + random.nextDouble() : 3);
            }
            if (!gather(bvh)) {
                wide++;
                continue;
            }
            BitSet things = gathered(bvh);
            for (int i = 0; i < RAYS; i++) {
                Vector from = new Vector(o[0][i], o[1][i], o[2][i]), way = new Vector(d[0][i], d[1][i], d[2][i]);
                for (int k = 0; k < boxes.length; k++) {
                    if (BvhTest.meets(boxes[k], from, way, distance[i])) {
                        assertTrue(things.get(k), "tile " + tile + ", ray " + i + " misses box " + k);
                        met++;
                    }
                }
            }
        }
        assertTrue(spread > .1 ? wide > 100 : met > 300, met + " met, " + wide + " too wide");
    }

    @ParameterizedTest(name = "to a light holds all that may be in the way: world offset {0}, origins {1} apart")
    @CsvSource({"0, .1", "1e6, .02", "-1e9, .1"})
    void holdsAllThatMayBeBeforeALight(double offset, double apart) {
        double[][] boxes = BvhTest.cubes(300, 2, .04, offset, 1);
        Bvh bvh = BvhTest.build(boxes);
        Random random = new Random(4);
        int met = 0;
        for (int tile = 0; tile < 800; tile++) {
            Vector axis = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector place = new Vector(offset + 2 * axis.x(), offset + 2 * axis.y(), offset + 2 * axis.z());
            boolean directional = tile % 2 == 0;
            LightSource light = directional ? new LightSource(true, -axis.x(), -axis.y(), -axis.z(), Colour.BLACK)
                    : new LightSource(false, place.x(), place.y(), place.z(), Colour.BLACK);
            for (int i = 0; i < RAYS; i++) {
                o[0][i] = offset + (directional ? 2 * axis.x() : 0) + apart * random.nextDouble();
                o[1][i] = offset + (directional ? 2 * axis.y() : 0) + apart * random.nextDouble();
                o[2][i] = offset + (directional ? 2 * axis.z() : 0) + apart * random.nextDouble();
            }
            intervals.enclose(rays, light, 0, RAYS);
            if (!beam.gather(intervals, bvh, 24)) {
                continue;
            }
            BitSet things = gathered(bvh);
            for (int i = 0; i < RAYS; i++) {
                Vector from = new Vector(o[0][i], o[1][i], o[2][i]);
                Vector way = directional ? new Vector(light.x(), light.y(), light.z()) : place.minus(from).unit();
                double far = directional ? Double.POSITIVE_INFINITY : place.minus(from).length();
                for (int k = 0; k < boxes.length; k++) {
                    if (BvhTest.meets(boxes[k], from, way, far)) {
                        assertTrue(things.get(k), "tile " + tile + ", ray " + i + " misses box " + k);
                        met++;
                    }
                }
            }
        }
        assertTrue(met > 300, met + " met");
    }

    @ParameterizedTest(name = "knows where its rays'' walks may begin: origins {0} apart, directions {1} apart")
    @CsvSource({"0, .002", "0, .1", ".02, .005", ".5, .3"})
    void knowsWhereWalksMayBegin(double apart, double spread) {
        double[][] boxes = BvhTest.cubes(5000, 2, .04, 0, 1);
        Bvh bvh = BvhTest.build(boxes);
        Random random = new Random(5);
        int deep = 0, met = 0;
        for (int tile = 0; tile < 200; tile++) {
            Vector axis = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector start = new Vector(random.nextDouble() - .5, random.nextDouble() - .5, random.nextDouble() - .5);
            for (int i = 0; i < RAYS; i++) {
                Vector from = new Vector(start.x() + apart * random.nextDouble(), start.y() + apart * random.nextDouble(),
                        start.z() + apart * random.nextDouble());
                set(i, from, new Vector(axis.x() + spread * random.nextGaussian(), axis.y() + spread * random.nextGaussian(),
                        axis.z() + spread * random.nextGaussian()).unit(), .1 * random.nextDouble());
            }
            gather(bvh);
            deep += beam.entry != bvh.root() ? 1 : 0;
            for (int i = 0; i < RAYS; i++) {
                Vector from = new Vector(o[0][i], o[1][i], o[2][i]), way = new Vector(d[0][i], d[1][i], d[2][i]);
                BitSet visited = BvhTest.visited(bvh, beam.entry, from, way, distance[i]);
                for (int k = 0; k < boxes.length; k++) {
                    if (BvhTest.meets(boxes[k], from, way, distance[i])) {
                        assertTrue(visited.get(k), "tile " + tile + ", ray " + i + " misses box " + k);
                        met++;
                    }
                }
            }
        }
        assertTrue(met > 500, met + " met");
        assertTrue(apart > .1 || deep > 100, "only " + deep + " below the root");
    }

    @Test
    void givesUpWhenItsRaysGoAllWays() {
        Bvh bvh = BvhTest.build(BvhTest.cubes(1000, 2, .01, 0, 1));
        Random random = new Random(3);
        for (int i = 0; i < RAYS; i++) {
            set(i, new Vector(0, 0, 0), new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit(), 9);
        }
        assertFalse(gather(bvh));
    }

    @Test
    void givesUpFromSoFarAwayThatDoublesDoNotReach() {
        Bvh bvh = BvhTest.build(BvhTest.cubes(1000, 2, .01, 0, 1));
        for (int i = 0; i < RAYS; i++) {
            set(i, new Vector(0, 0, 1e12), new Vector(0, 0, -1), Double.POSITIVE_INFINITY);
        }
        assertFalse(gather(bvh));
    }

    @Test
    void findsNothingBehindOrBeyond() {
        Bvh bvh = BvhTest.build(BvhTest.cubes(1000, 2, .01, 0, 1));
        for (int i = 0; i < RAYS; i++) {
            set(i, new Vector(0, 0, 5), new Vector(0, 0, 1), Double.POSITIVE_INFINITY);
        }
        assertTrue(gather(bvh) && beam.count == 0);
        for (int i = 0; i < RAYS; i++) {
            set(i, new Vector(0, 0, 5), new Vector(0, 0, -1), 3);
        }
        assertTrue(gather(bvh) && beam.count == 0);
    }
}
