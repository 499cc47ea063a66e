package raytracer.tracer.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Mesh;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.bvh.BvhWalk;
import raytracer.tracer.surface.SieveLine;

/** The sieve of triangles. */
class TriangleSieveTest {

    private static final int COUNT = 300;

    private static Mesh triangles(Random random, double offset, double size) {
        Mesh.Builder mesh = new Mesh.Builder();
        for (int k = 0; k < COUNT; k++) {
            double x = offset + random.nextGaussian(), y = offset + random.nextGaussian(), z = random.nextGaussian();
            for (int corner = 0; corner < 3; corner++) {
                mesh.addVertex(x + size * random.nextGaussian(), y + size * random.nextGaussian(),
                        z + size * random.nextGaussian());
            }
            mesh.addTriangle(3 * k, 3 * k + 1, 3 * k + 2);
        }
        return mesh.build();
    }

    private static Bvh tree(Mesh mesh) {
        return BvhBuilder.build(COUNT, new TriangleBounds(mesh), Triangles.LEAF_SIZE);
    }

    private static boolean lets(TriangleSieve sieve, SieveLine line, int k) {
        return sieve.mayHit(line, k, k + 1) == 1;
    }

    private static double between(double a, double b, double c, double u, double v) {
        return a + u * (b - a) + v * (c - a);
    }

    private static Vector point(Mesh mesh, int k, double u, double v) {
        Vector a = mesh.corner(k, 0), b = mesh.corner(k, 1), c = mesh.corner(k, 2);
        return new Vector(between(a.x(), b.x(), c.x(), u, v), between(a.y(), b.y(), c.y(), u, v),
                between(a.z(), b.z(), c.z(), u, v));
    }

    @ParameterizedTest(name = "lets every ray through that aims within: world offset {0}, triangles of {1}, from {2}")
    @CsvSource({"0, .05, 5", "0, 1, .5", "1e6, .05, 5", "0, 1e-6, 5", "0, .05, 1e6", "-1e9, .1, 3",
        "0, 1e-9, 4", "0, 1e-11, 4", "0, 1e-13, 4", "0, 1e-30, 4"})
    void letsThroughWhatAimsWithin(double offset, double size, double away) {
        Random random = new Random(5);
        Mesh mesh = triangles(random, offset, size);
        Bvh bvh = tree(mesh);
        TriangleSieve sieve = new TriangleSieve(mesh, bvh);
        SieveLine line = new SieveLine();
        BvhWalk walk = new BvhWalk();
        int stopped = 0;
        for (int i = 0; i < 20_000; i++) {
            int k = random.nextInt(COUNT);
            // Inside, on edges, and on corners.
            double u = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
            double v = u == 1 ? 0 : random.nextInt(3) == 0 ? 0 : (1 - u) * random.nextDouble();
            Vector target = point(mesh, bvh.order()[k], u, v);
            Vector d = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector o = new Vector(target.x() - away * d.x(), target.y() - away * d.y(), target.z() - away * d.z());
            Vector way = target.minus(o).unit();
            if (!walk.start(bvh, o.x(), o.y(), o.z(), way.x(), way.y(), way.z())) {
                continue;
            }
            line.set(walk, way.x(), way.y(), way.z(), 0, Rounding.EYE_DIRECTION);
            assertTrue(lets(sieve, line, k), "ray " + i + " at triangle " + k);
            stopped += lets(sieve, line, (k + 1) % COUNT) ? 0 : 1;
        }
        assertTrue(size < 1e-10 || stopped > 10_000, stopped + " stopped that pass another triangle by");
    }

    @ParameterizedTest(name = "lets a ray through that may be {0} off")
    @CsvSource({".01", "1e-4", "1e-9"})
    void letsThroughWhatMayBeOff(double error) {
        Random random = new Random(6);
        Mesh mesh = triangles(random, 0, .5);
        Bvh bvh = tree(mesh);
        TriangleSieve sieve = new TriangleSieve(mesh, bvh);
        SieveLine line = new SieveLine();
        BvhWalk walk = new BvhWalk();
        for (int i = 0; i < 20_000; i++) {
            int k = random.nextInt(COUNT);
            Vector corner = point(mesh, bvh.order()[k], random.nextInt(2), 0);
            Vector d = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            double[] off = random.doubles(3, -error, error).toArray();
            Vector o = new Vector(corner.x() - 3 * d.x() + off[0], corner.y() - 3 * d.y() + off[1],
                    corner.z() - 3 * d.z() + off[2]);
            if (walk.start(bvh, o.x(), o.y(), o.z(), d.x(), d.y(), d.z())) {
                line.set(walk, d.x(), d.y(), d.z(), error * bvh.space().scale(), Rounding.EYE_DIRECTION);
                assertTrue(lets(sieve, line, k), "ray " + i + " at triangle " + k);
            }
        }
    }

    @Test
    @DisplayName("tells of each triangle of a leaf what it tells of that triangle alone")
    void tellsOfEachWhatItTellsOfOneAlone() {
        Random random = new Random(7);
        Mesh mesh = triangles(random, 0, 1);
        Bvh bvh = tree(mesh);
        TriangleSieve sieve = new TriangleSieve(mesh, bvh);
        SieveLine line = new SieveLine();
        int some = 0;
        for (int i = 0; i < 2000; i++) {
            Vector d = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            line.set(new BvhWalk(), d.x(), d.y(), d.z(), 0, Rounding.EYE_DIRECTION);
            int first = random.nextInt(COUNT - Bvh.LEAF_SIZE), end = first + random.nextInt(Bvh.LEAF_SIZE + 1);
            int let = sieve.mayHit(line, first, end);
            for (int k = first; k < end; k++) {
                assertEquals(lets(sieve, line, k), (let >> k - first & 1) == 1, "ray " + i + " at triangle " + k);
            }
            assertEquals(0, let >>> end - first, "ray " + i);
            some += Integer.bitCount(let);
        }
        assertTrue(some > 500, some + " let through");
    }
}
