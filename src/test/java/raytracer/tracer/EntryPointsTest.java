package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Colour;
import raytracer.scene.Vector;

@DisplayName("Entry points")
class EntryPointsTest {

    private static final int RAYS = 60;

    private final double[][] boxes = new double[4000][];
    private final Rays rays = new Rays(new int[0], List.of());
    private final EntryPoints entryPoints = new EntryPoints();
    private final BvhWalk walk = new BvhWalk();

    // What was seen, so that no test is empty.
    private int met;
    private int spared;

    private static Vector random(Random random, double spread) {
        return new Vector(
                spread * random.nextGaussian(), spread * random.nextGaussian(), spread * random.nextGaussian());
    }

    private static Vector plus(Vector a, double t, Vector b) {
        return new Vector(a.x() + t * b.x(), a.y() + t * b.y(), a.z() + t * b.z());
    }

    private static void set(Vectors all, int i, Vector v) {
        all.x()[i] = v.x();
        all.y()[i] = v.y();
        all.z()[i] = v.z();
    }

    private static Vector get(Vectors all, int i) {
        return new Vector(all.x()[i], all.y()[i], all.z()[i]);
    }

    /** Finds entry points for the rays of a beam that found too much, and walks each ray from there. */
    private void assertLeadToAll(Bvh bvh, Beam beam, Vectors direction, double limit) {
        if (beam.gather(bvh)) {
            return;
        }
        entryPoints.find(bvh, beam, rays.origin, direction, 0, RAYS);
        for (int i = 0; i < RAYS; i++) {
            Vector o = get(rays.origin, i), d = get(direction, i);
            BitSet visited = visited(bvh, i, o, d, limit);
            spared += entryPoints.leadIn(i) ? 0 : 1;
            for (int k = 0; k < boxes.length; k++) {
                if (BvhTest.meets(boxes[k], o, d, limit)) {
                    assertTrue(visited.get(k), "ray " + i + " misses box " + k);
                    met++;
                }
            }
        }
    }

    private BitSet visited(Bvh bvh, int ray, Vector o, Vector d, double limit) {
        BitSet things = new BitSet();
        if (entryPoints.leadIn(ray) && walk.start(bvh, o.x(), o.y(), o.z(), d.x(), d.y(), d.z())) {
            entryPoints.enter(walk, ray);
            while (walk.nextLeaf(limit)) {
                for (int k = walk.first(); k < walk.end(); k++) {
                    assertTrue(!things.get(bvh.order()[k]), "a thing comes once");
                    things.set(bvh.order()[k]);
                }
            }
        }
        return things;
    }

    private Bvh build(double offset) {
        double[][] cubes = BvhTest.cubes(boxes.length, 2, .03, offset, 1);
        System.arraycopy(cubes, 0, boxes, 0, boxes.length);
        for (double[] box : boxes) {
            // A sheet, so that a beam at its rim has rays that pass it by.
            box[1] = offset + (box[1] - offset) / 64;
            box[4] = offset + (box[4] - offset) / 64;
        }
        return BvhTest.build(boxes, 2);
    }

    @ParameterizedTest(name = "lead to all: world offset {0}, {1} away, directions {2} apart, origins {3}")
    @CsvSource({"0, 4, .01, 0", "0, 4, .02, .02", "1e6, 4, .02, .01", "-1e7, 3, .02, .05",
        "0, 1e5, 1e-6, .05", "0, .9, .05, .03"})
    void leadRaysToAllTheyMeet(double offset, double away, double spread, double apart) {
        Bvh bvh = build(offset);
        Random random = new Random(2);
        for (int tile = 0; tile < 60; tile++) {
            Vector axis = random(random, 1).unit();
            Vector start = plus(plus(new Vector(offset, offset, offset), -away, axis), .3, random(random, 1));
            for (int i = 0; i < RAYS; i++) {
                set(rays.origin, i, plus(start, apart, random(random, 1)));
                set(rays.direction, i, plus(axis, spread, random(random, 1)).unit());
                rays.distance[i] = Double.POSITIVE_INFINITY;
            }
            Beam beam = new Beam();
            beam.take(rays, 0, RAYS);
            assertLeadToAll(bvh, beam, rays.direction, Double.POSITIVE_INFINITY);
        }
        assertTrue(met > 1_000 && spared > 20, met + " met, " + spared + " spared");
    }

    @ParameterizedTest(name = "lead to all before a lamp: world offset {0}, lamp {1} away, origins {2} apart")
    @CsvSource({"0, 4, .1", "0, 1e3, .05", "1e6, 4, .1", "-1e7, 4, .1"})
    void leadToAllBeforeALamp(double offset, double away, double apart) {
        Bvh bvh = build(offset);
        Random random = new Random(3);
        Vectors direction = new Vectors();
        for (int tile = 0; tile < 80; tile++) {
            Vector axis = random(random, 1).unit(), centre = new Vector(offset, offset, offset);
            Vector place = plus(centre, away, axis), start = plus(plus(centre, -1.5, axis), .2, random(random, 1));
            boolean directional = tile % 2 == 0;
            Lamp lamp = directional ? new Lamp(true, axis.x(), axis.y(), axis.z(), Colour.BLACK)
                    : new Lamp(false, place.x(), place.y(), place.z(), Colour.BLACK);
            for (int i = 0; i < RAYS; i++) {
                Vector o = plus(start, apart, random(random, 1));
                set(rays.origin, i, o);
                set(direction, i, directional ? axis : place.minus(o).unit());
            }
            Beam beam = new Beam();
            beam.take(rays, lamp, 0, RAYS);
            assertLeadToAll(bvh, beam, direction, directional ? Double.POSITIVE_INFINITY : away);
        }
        assertTrue(met > 1_000 && spared > 20, met + " met, " + spared + " spared");
    }

    @ParameterizedTest(name = "are not used by rays that start farther away than doubles reach: {0}")
    @CsvSource({"1e7", "1e12"})
    void areNotUsedFromFarAway(double away) {
        Bvh bvh = build(0);
        Lamp lamp = new Lamp(false, 0, 2, 0, Colour.BLACK);
        Vectors direction = new Vectors();
        for (int i = 0; i < RAYS; i++) {
            set(rays.origin, i, new Vector(away * 1e-9 * i, -away, 0));
            set(direction, i, new Vector(0, 1, 0));
        }
        Beam beam = new Beam();
        beam.take(rays, lamp, 0, RAYS);
        assertFalse(beam.gather(bvh));
        assertFalse(beam.isNarrow(bvh), "the rays' own origins count, not only the lamp");
    }
}
