package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.exact.ExactKernels;
import raytracer.scene.Vector;
import raytracer.tracer.Pictures;
import raytracer.tracer.Probe;

/** Spheres hold where the quadratic formula fails. */
class SphereStabilityTest {

    private static final int RAYS = 20_000;

    private static Vector direction(Random random) {
        return new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
    }

    private static String sphere(Vector c, double r) {
        return "sphere " + c.x() + " " + c.y() + " " + c.z() + " " + r;
    }

    @ParameterizedTest(name = "far away, at {0} radii the formula misjudges at least {1} of 20,000 grazing rays")
    @CsvSource({"1e3, 0", "1e6, 1", "3e7, 2000", "1e8, 4000"})
    void far(double distance, int naiveAtLeast) throws Exception {
        Random random = new Random(1);
        Vector centre = new Vector(distance, .3 * distance, -.7 * distance);
        Probe probe = new Probe(sphere(centre, 1));
        int ours = 0, naive = 0;
        for (int i = 0; i < RAYS; i++) {
            // Past the sphere, inside or outside by a millionth to a tenth of its radius.
            double clearance = (random.nextBoolean() ? 1 : -1) * Math.pow(10, -6 + 5 * random.nextDouble());
            Vector side = centre.cross(direction(random)).unit();
            Vector target = Naive.point(centre, side, 1 + clearance);
            Vector d = target.unit();
            Vector origin = new Vector(0, 0, 0);
            boolean truth = ExactKernels.clearance(origin, d, centre, 1) <= 0;
            ours += (probe.shoot(origin, d) != null) != truth ? 1 : 0;
            naive += Double.isNaN(Naive.sphere(origin, d, centre, 1, 0)) == truth ? 1 : 0;
        }
        assertEquals(0, ours, "wrong answers of the tracer");
        assertTrue(naive >= naiveAtLeast, naive + " wrong answers of the formula");
    }

    @ParameterizedTest(name = "a ground of radius {0} looks like a plane")
    @ValueSource(strings = {"1e18", "1e40", "1e100", "1e150"})
    void ground(String radius) throws Exception {
        String scene = "size 64 48\ncamera 0 1 6 0 .5 0 0 1 0 40\ndirectional 1 1 1 .8 .8 .8\ndiffuse .8 .3 .3\n%s\n"
                + "diffuse .3 .3 .8\nsphere 0 .6 0 .6\n";
        double[] ball = Pictures.trace(String.format(scene, "sphere 0 -" + radius + " 0 " + radius));
        double[] plane = Pictures.trace(String.format(scene, "plane 0 0 0 0 1 0"));
        assertArrayEquals(plane, ball, 1e-15);
    }

    @Test
    @DisplayName("what is around a scale of 1e-140 or 1e140 is the same picture, bit for bit")
    void scales() throws Exception {
        double[] picture = Pictures.trace(ballOnBall(0));
        for (int exponent : new int[] {-465, -200, 200, 465}) {
            assertArrayEquals(picture, Pictures.trace(ballOnBall(exponent)), "2^" + exponent);
        }
    }

    private static String ballOnBall(int exponent) {
        double s = Math.scalb(1.0, exponent);
        return "size 32 24\nmaxdepth 3\ncamera 0 " + s + " " + 6 * s + " 0 " + s / 2 + " 0 0 1 0 40\npoint " + 3 * s + " "
                + 5 * s + " " + 4 * s + " .9 .8 .7\ndiffuse .7 .3 .2\nspecular .3 .3 .3\nsphere 0 " + s + " 0 " + s
                + "\nsphere " + s + " " + s / 4 + " " + s + " " + s / 4 + "\nmaxverts 3\nvertex " + -2 * s + " 0 " + -s
                + "\nvertex " + s + " 0 " + -s + "\nvertex 0 " + 2 * s + " " + -s + "\ntri 0 1 2\nplane 0 0 0 0 1 0\n";
    }

    @ParameterizedTest(name = "huge and close, radius {0}: the formula's distance is off by {1} and more")
    @CsvSource({"1e4, 1e-13", "1e6, 1e-10", "1e9, 1e-7"})
    void huge(double radius, double naiveAtLeast) throws Exception {
        Random random = new Random(2);
        double gap = .001;
        Vector centre = new Vector(0, -radius, 0);
        Probe probe = new Probe(sphere(centre, radius));
        Vector eye = new Vector(0, gap, 0);
        double ours = 0, naive = 0;
        for (int i = 0; i < RAYS; i++) {
            Vector d = new Vector(random.nextGaussian(), -1 - random.nextDouble(), random.nextGaussian()).unit();
            double truth = ExactKernels.sphere(eye, d, centre, radius);
            ours = Math.max(ours, Math.abs(probe.shoot(eye, d).distance() - truth) / truth);
            naive = Math.max(naive, Math.abs(Naive.sphere(eye, d, centre, radius, 0) - truth) / truth);
        }
        assertTrue(ours < 2e-15, "the tracer's distance is off by " + ours);
        assertTrue(naive > naiveAtLeast, "the formula's by " + naive);
    }

    @ParameterizedTest(name = "leaving one at {0}: outward rays meet it again with an epsilon of {1}")
    @CsvSource({"0, 0, 0.05", "1e6, 1e-9, 0.005", "1e8, 1e-9, 0.2"})
    void leavingOutwards(double offset, double epsilon, double naiveAtLeast) throws Exception {
        Random random = new Random(3);
        Vector centre = new Vector(offset, offset, offset);
        Probe probe = new Probe(sphere(centre, 1));
        int naive = 0, tried = 0;
        for (int i = 0; i < RAYS; i++) {
            Vector in = direction(random);
            Probe.Meeting start = probe.shoot(Naive.point(centre, in, -3), in);
            Vector out = direction(random);
            if (out.dot(start.normal()) > .001) {
                tried++;
                naive += Double.isNaN(Naive.sphere(start.point(), out, centre, 1, epsilon)) ? 0 : 1;
                assertNull(probe.continueTowards(out), "an outward ray meets nothing");
                probe.shoot(Naive.point(centre, in, -3), in);
                assertTrue(probe.seesAlong(out), "the light is seen");
            }
        }
        assertTrue(naive > naiveAtLeast * tried, naive + " of " + tried + " with the epsilon");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e6, 1e8})
    @DisplayName("leaving one inwards, a ray meets the other side; skipping the sphere would lose it")
    void leavingInwards(double offset) throws Exception {
        Random random = new Random(4);
        Vector centre = new Vector(offset, offset, offset);
        Probe probe = new Probe(sphere(centre, 1));
        for (int i = 0; i < RAYS; i++) {
            Vector out = direction(random), in = direction(random);
            Probe.Meeting start = probe.shoot(centre, out);
            double inwards = -in.dot(start.normal());
            if (inwards > .001) {
                Probe.Meeting other = probe.continueTowards(in);
                assertNotNull(other);
                assertEquals(2 * inwards, other.distance(), 4e-15 * (1 + offset));
            }
        }
    }

    @Test
    @DisplayName("of two that mirror each other, the first declared is seen along the whole seam")
    void ties() throws Exception {
        Random random = new Random(5);
        int ours = 0, naiveFirst = 0, naiveSecond = 0;
        Vector a = new Vector(33, 30, 4), b = new Vector(30, 33, 4);
        // The same pair turned about: no order of summation is the same for both.
        Vector c = new Vector(3, 3.3, 30), e = new Vector(3, 30, 3.3);
        Probe first = new Probe(sphere(a, 4) + "\n" + sphere(b, 4)), second = new Probe(sphere(c, 29) + "\n" + sphere(e, 29));
        for (int i = 0; i < RAYS; i++) {
            double x = 29 + 5 * random.nextDouble();
            Vector d = new Vector(x, x, -145 - random.nextDouble()).unit();
            Probe.Meeting m = first.shoot(new Vector(0, 0, 150), d);
            ours += m != null && m.shape() != 0 ? 1 : 0;
            double side = 9 * random.nextDouble() - 4;
            d = new Vector(-100, side, side).unit();
            Vector o = new Vector(150, 10, 10);
            m = second.shoot(o, d);
            ours += m != null && m.shape() != 0 ? 1 : 0;
            double t0 = Naive.sphere(o, d, c, 29, 0), t1 = Naive.sphere(o, d, e, 29, 0);
            naiveFirst += t0 < t1 ? 1 : 0;
            naiveSecond += t1 < t0 ? 1 : 0;
        }
        assertEquals(0, ours, "rays that see the second");
        assertTrue(naiveFirst > 5 && naiveSecond > 5, "rounding decides: " + naiveFirst + ", " + naiveSecond);
    }

    @Test
    @DisplayName("seen from inside, it is met in every direction")
    void inside() throws Exception {
        Random random = new Random(6);
        Probe probe = new Probe("sphere 1e5 0 0 2\nsphere 1e5 0 0 3");
        for (int i = 0; i < RAYS; i++) {
            Vector o = new Vector(1e5 + random.nextDouble(), random.nextDouble(), random.nextDouble());
            Probe.Meeting m = probe.shoot(o, direction(random));
            assertEquals(0, m.shape());
            assertTrue(m.distance() > 0 && m.distance() < 4);
        }
    }
}
