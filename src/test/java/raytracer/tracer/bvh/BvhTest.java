package raytracer.tracer.bvh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.scene.Vector;

/** The tree. */
public class BvhTest {

    /** Cubes as things: six numbers each. */
    public static double[][] cubes(int count, double spread, double size, double offset, long seed) {
        Random random = new Random(seed);
        double[][] cubes = new double[count][6];
        for (double[] cube : cubes) {
            double half = size * random.nextDouble();
            for (int axis = 0; axis < 3; axis++) {
                double centre = offset + spread * (random.nextDouble() - .5);
                cube[axis] = centre - half;
                cube[axis + 3] = centre + half;
            }
        }
        return cubes;
    }

    public static Bvh build(double[][] boxes) {
        Bounds bounds = new Bounds() {
            @Override
            public void of(int k, double[] box) {
                System.arraycopy(boxes[k], 0, box, 0, 6);
            }

            @Override
            public boolean areSame(int k, int other) {
                return Arrays.equals(boxes[k], boxes[other]);
            }
        };
        return BvhBuilder.build(boxes.length, bounds, Bvh.LEAF_SIZE);
    }

    private static BitSet visited(Bvh bvh, Vector o, Vector d, double limit) {
        return visited(bvh, bvh.root(), o, d, limit);
    }

    /** The things that a ray comes to below one node, and those that every ray comes to. */
    public static BitSet visited(Bvh bvh, int entry, Vector o, Vector d, double limit) {
        BvhWalk walk = new BvhWalk();
        if (walk.start(bvh, o.x(), o.y(), o.z(), d.x(), d.y(), d.z())) {
            walk.enter(entry);
        }
        BitSet things = new BitSet();
        for (int k = 0; k < bvh.oversized(); k++) {
            things.set(bvh.order()[k]);
        }
        while (walk.nextLeaf(limit)) {
            for (int k = walk.first; k < walk.end; k++) {
                assertTrue(!things.get(bvh.order()[k]), "a thing comes once");
                things.set(bvh.order()[k]);
            }
        }
        return things;
    }

    /** Whether a ray meets a box, shrunk by a trifle so that rounding here does not matter. */
    public static boolean meets(double[] box, Vector o, Vector d, double limit) {
        double[] os = {o.x(), o.y(), o.z()}, ds = {d.x(), d.y(), d.z()};
        double near = 0, far = limit;
        for (int axis = 0; axis < 3; axis++) {
            double shrink = 1e-12 * (Math.abs(box[axis]) + Math.abs(box[axis + 3]) + Math.abs(os[axis]));
            double low = box[axis] + shrink - os[axis], high = box[axis + 3] - shrink - os[axis];
            if (low > high) {
                return false; // shrunk to nothing
            }
            if (ds[axis] == 0) {
                if (low > 0 || high < 0) {
                    return false;
                }
                continue;
            }
            near = Math.max(near, Math.min(low / ds[axis], high / ds[axis]));
            far = Math.min(far, Math.max(low / ds[axis], high / ds[axis]));
        }
        return near < far * (1 - 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 10, -1e6, 1e9})
    void leadsEveryRayToEverythingItMeets(double offset) {
        double[][] boxes = cubes(3000, 2, .05, offset, 1);
        Bvh bvh = build(boxes);
        Random random = new Random(2);
        int met = 0;
        for (int i = 0; i < 3000; i++) {
            double away = i % 3 == 0 ? 1 : i % 3 == 1 ? 100 : 1e7;
            Vector d = i % 5 == 0
                    ? new Vector(i % 2 == 0 ? -0.0 : 0, i % 4 == 0 ? 1 : 0, i % 4 == 0 ? 0 : -1)
                    : new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector target = new Vector(offset + random.nextDouble() - .5, offset + random.nextDouble() - .5,
                    offset + random.nextDouble() - .5);
            Vector o = new Vector(target.x() - away * d.x(), target.y() - away * d.y(), target.z() - away * d.z());
            double limit = i % 2 == 0 ? Double.POSITIVE_INFINITY : away + .3;
            BitSet visited = visited(bvh, o, d, limit);
            for (int k = 0; k < boxes.length; k++) {
                if (meets(boxes[k], o, d, limit)) {
                    assertTrue(visited.get(k), "ray " + i + " misses box " + k);
                    met++;
                }
            }
        }
        assertTrue(met > 5_000, met + " met");
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, -1})
    void leadsARayToTheNearestOfANodesChildrenFirst(double along) {
        double[][] boxes = new double[4 * Bvh.LEAF_SIZE][];
        for (int k = 0; k < boxes.length; k++) {
            double x = 10 * (k % 4), y = .1 * (k / 4);
            boxes[k] = new double[] {x, y, 0, x + 1, y + .1, .1};
        }
        Bvh bvh = build(boxes);
        assertEquals(1, bvh.nodes().length / Bvh.NODE_STRIDE);
        BvhWalk walk = new BvhWalk();
        assertTrue(walk.start(bvh, along > 0 ? -5 : 45, .05, .05, along, 0, 0));
        assertTrue(walk.nextLeaf(Double.POSITIVE_INFINITY));
        assertEquals(along > 0 ? 0 : 3, bvh.order()[walk.first] % 4);
    }

    @Test
    void hasNoFreePlaceBesideALeafThatCouldBeTwo() {
        Bvh bvh = build(cubes(3000, 2, .05, 0, 1));
        int withFreePlaces = 0;
        for (int node = 0; node < bvh.nodes().length; node += Bvh.NODE_STRIDE) {
            int[] children = IntStream.range(node, node + Bvh.WIDTH)
                    .filter(at -> bvh.nodes()[at + Bvh.HALF] >= 0).map(bvh::child).toArray();
            if (children.length < Bvh.WIDTH) {
                withFreePlaces++;
                for (int child : children) {
                    assertTrue(child < 0 && Bvh.leafEnd(child) - Bvh.leafFirst(child) <= 2, "a child of node " + node);
                }
            }
        }
        assertTrue(withFreePlaces < bvh.nodes().length / Bvh.NODE_STRIDE / 10, withFreePlaces + " with free places");
    }

    @Test
    void sparesMostRaysMostThings() {
        Bvh bvh = build(cubes(3000, 2, .02, 0, 1));
        BitSet visited = visited(bvh, new Vector(0, 0, 5), new Vector(0, 0, -1), Double.POSITIVE_INFINITY);
        assertTrue(visited.cardinality() < 60, visited.cardinality() + " visited");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 5, 8, 9, 50, 100_000})
    void holdsEveryThingOnce(int count) {
        int[] order = build(cubes(count, 2, .01, 0, 7)).order().clone();
        Arrays.sort(order);
        for (int i = 0; i < count; i++) {
            assertEquals(i, order[i]);
        }
    }

    private static int reachable(Bvh bvh, int node) {
        int count = 1;
        for (int child = 0; child < Bvh.WIDTH; child++) {
            int at = node * Bvh.NODE_STRIDE + child;
            count += bvh.nodes()[at + Bvh.HALF] >= 0 && bvh.child(at) >= 0 ? reachable(bvh, bvh.child(at)) : 0;
        }
        return count;
    }

    @ParameterizedTest
    @ValueSource(ints = {50, 100_000})
    void holdsNoNodeInVain(int count) {
        Bvh bvh = build(cubes(count, 2, .01, 0, 7));
        assertEquals(reachable(bvh, bvh.root()), bvh.nodes().length / Bvh.NODE_STRIDE);
    }

    @Test
    void takesThingsThatAllHaveOneCentre() {
        double[][] boxes = new double[10_000][];
        for (int k = 0; k < boxes.length; k++) {
            double half = 1 + 8.0 * k / boxes.length;
            boxes[k] = new double[] {-half, -half, -half, half, half, half};
        }
        BitSet visited = visited(build(boxes), new Vector(0, 0, 50), new Vector(0, 0, -1), Double.POSITIVE_INFINITY);
        assertEquals(10_000, visited.cardinality());
    }

    @Test
    void takesFlatThings() {
        double[][] boxes = new double[100][];
        for (int k = 0; k < 100; k++) {
            boxes[k] = new double[] {k, 0, 0, k + 1, 1, 0};
        }
        Bvh bvh = build(boxes);
        assertTrue(visited(bvh, new Vector(50.5, .5, 5), new Vector(0, 0, -1), 10).get(50));
        assertTrue(visited(bvh, new Vector(-5, .5, 0), new Vector(1, 0, 0), 200).cardinality() == 100);
    }

    @Test
    void keepsWhatIsMuchWiderThanTheRestBeside() {
        double[][] boxes = cubes(1000, 2, .01, 0, 7);
        boxes[500] = new double[] {-1e4, -2e4, -1e4, 1e4, -1, 1e4};
        Bvh bvh = build(boxes);
        assertEquals(1, bvh.oversized());
        assertEquals(500, bvh.order()[0]);
        assertTrue(bvh.space().scale() >= .25, "the tree is as large as the rest");
    }

    @ParameterizedTest(name = "of {0} parts of the width of all: {1} beside")
    @CsvSource({".49, 0", ".51, 1"})
    void keepsWhatIsMoreThanHalfAsWideAsAllBeside(double part, int beside) {
        // So many that several threads look for the widest.
        double[][] boxes = cubes(100_000, 1.9, .01, 0, 11);
        boxes[0] = new double[] {-1, -1, -1, -1, -1, -1};
        boxes[1] = new double[] {1, 1, 1, 1, 1, 1};
        boxes[70_000] = new double[] {-part, 0, 0, part, .1, .1};
        Bvh bvh = build(boxes);
        assertEquals(beside, bvh.oversized());
        assertEquals(beside, IntStream.range(0, bvh.oversized()).filter(k -> bvh.order()[k] == 70_000).count());
    }

    @Test
    void hasTheFirstOfManyThatAreTheSame() {
        double[][] boxes = cubes(3000, 2, .1, 0, 7);
        for (int k = 200; k < boxes.length; k++) {
            // The same three over and over: 11, 12 and 13.
            boxes[k] = boxes[11 + k % 3];
        }
        Bvh bvh = build(boxes);
        for (int k = 11; k < 14; k++) {
            Vector middle = new Vector((boxes[k][0] + boxes[k][3]) / 2, (boxes[k][1] + boxes[k][4]) / 2,
                    (boxes[k][2] + boxes[k][5]) / 2);
            BitSet visited = visited(bvh, middle, new Vector(0, 0, 1), 1e-3);
            assertTrue(visited.get(k), "the first is there");
            assertTrue(visited.cardinality() < 200, visited.cardinality() + " are tried");
        }
    }
}
