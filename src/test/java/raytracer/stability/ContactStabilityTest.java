package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.scene.Vector;
import raytracer.tracer.Probe;

/** Where surfaces touch. */
class ContactStabilityTest {

    private static final int POINTS = 5_000;

    @ParameterizedTest(name = "scale {0}, offset {1}: no light leaks under a ball on a floor and no acne grows around it")
    @CsvSource({"1, 0", "1e-6, 0", "1e7, 0", "1, 1e3", "1, 1e6", "1e-3, 1e3", "1e7, 1e6"})
    void ballOnFloor(double scale, double offset) throws Exception {
        Random random = new Random(1);
        Vector centre = new Vector(offset, offset + scale, offset);
        Probe probe = new Probe("plane " + offset + " " + offset + " " + offset + " 0 1 0\nsphere " + centre.x() + " "
                + centre.y() + " " + centre.z() + " " + scale);
        int leaks = 0, acne = 0;
        // At a distance x from the contact the gap is x^2 / 2; what the coordinates cannot hold is left out.
        double least = Math.max(1e-6, 4 * Math.sqrt(Math.ulp(offset) / scale));
        for (int i = 0; i < POINTS; i++) {
            double x = least * Math.pow(.5 / least, random.nextDouble()), angle = 2 * Math.PI * random.nextDouble();
            Vector target = new Vector(offset + scale * x * Math.cos(angle), offset, offset + scale * x * Math.sin(angle));
            Vector eye = new Vector(target.x() + 3 * (target.x() - offset) + scale * Math.cos(angle),
                    offset + .2 * x * scale, target.z() + 3 * (target.z() - offset) + scale * Math.sin(angle));
            Probe.Meeting m = probe.shoot(eye, target.minus(eye));
            assertNotNull(m);
            if (m.shape() == 0) {
                leaks += probe.seesAlong(new Vector(0, 1, 0)) ? 1 : 0;
                acne += probe.seesAlong(new Vector(Math.cos(angle), .1 * x, Math.sin(angle))) ? 0 : 1;
            }
        }
        assertEquals(0, leaks, "points under the ball that see the light above it");
        assertEquals(0, acne, "points that do not see a light on their own side");
    }

    @Test
    @DisplayName("a floor a hair below the top of a planet sees no light above, though the perpendicular cannot tell")
    void floorInPlanet() throws Exception {
        Random random = new Random(3);
        Probe probe = new Probe("plane 0 -1e-11 0 0 1 0\nsphere 0 -1e6 0 1e6");
        int leaks = 0;
        for (int i = 0; i < POINTS; i++) {
            Probe.Meeting m = probe.shoot(new Vector(1e-6 * random.nextDouble(), -1, 1e-6 * random.nextDouble()),
                    new Vector(0, 1, 0));
            assertEquals(0, m.shape());
            Vector light = new Vector(random.nextDouble(), 1 + random.nextDouble(), random.nextDouble());
            leaks += probe.seesPoint(light) ? 1 : 0;
        }
        assertEquals(0, leaks);
    }

    @Test
    @DisplayName("any fixed epsilon either leaks or makes acne")
    void epsilons() {
        for (double epsilon : new double[] {1e-12, 1e-9, 1e-6, 1e-3}) {
            Random random = new Random(2);
            int leaks = 0, acne = 0;
            for (int i = 0; i < POINTS; i++) {
                // Leak: the floor near the contact of a small ball. Acne: a ball far from the origin, from outside.
                double r = 1e-4, x = r * Math.pow(10, -5 * random.nextDouble());
                Vector below = new Vector(x, 0, 0);
                leaks += Double.isNaN(Naive.sphere(below, new Vector(0, 1, 0), new Vector(0, r, 0), r, epsilon))
                        || Naive.sphere(below, new Vector(0, 1, 0), new Vector(0, r, 0), r, epsilon) > r ? 1 : 0;
                Vector centre = new Vector(1e7, 1e7, 1e7);
                Vector n = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
                acne += Double.isNaN(Naive.sphere(Naive.point(centre, n, 1), n, centre, 1, epsilon)) ? 0 : 1;
            }
            assertTrue(leaks + acne > POINTS / 100, epsilon + ": " + leaks + " leaks, " + acne + " acne");
        }
    }

    @ParameterizedTest(name = "a box on a box, offset {0}: the faces that touch let no light in, the others get it all")
    @ValueSource(doubles = {0, 1e3, 1e6})
    void boxOnBox(double offset) throws Exception {
        Random random = new Random(3);
        Families.Writer w = new Families.Writer(random, 1, offset);
        w.text("maxverts 100");
        w.box(0, -1, 0, 1, 1);
        w.box(.25, 0, .125, .5, .5);
        Probe probe = new Probe(w.toString());
        for (int i = 0; i < POINTS; i++) {
            // On the upper box's side x = .75, next to the seam; light from the same side, above and level.
            double y = Math.pow(10, -9 * random.nextDouble()) / 4, z = random.nextDouble() / 2;
            Vector eye = new Vector(offset + 4, offset + 1, offset);
            Vector target = new Vector(offset + .75, offset + y, offset + z);
            Probe.Meeting m = probe.shoot(eye, target.minus(eye));
            assertTrue(m.shape() >= 12 || y < 1e-8, "the upper box is seen");
            if (m.shape() >= 12 && Math.abs(m.normal().x()) == 1) {
                assertTrue(probe.seesAlong(new Vector(1, .1, 0)), "light from the side");
                assertFalse(probe.seesAlong(new Vector(-1, .1, 0)), "light through the box");
            }
            // On the lower box's top beside the seam.
            target = new Vector(offset + .75 + y, offset, offset + z);
            m = probe.shoot(eye, target.minus(eye));
            if (m.shape() < 12 && m.normal().y() == 1) {
                assertTrue(probe.seesAlong(new Vector(1, .1, 0)), "light from outside");
                if (m.point().x() - offset < .9) {
                    assertFalse(probe.seesAlong(new Vector(-1, .1, 0)), "light from behind the upper box");
                }
            }
        }
    }

    @Test
    @DisplayName("a light past the limb of a planet is seen if the way to it clears the planet by nanometres")
    void lightPastTheLimb() throws Exception {
        Random random = new Random(6);
        BigDecimal radius = new BigDecimal("6.4e6");
        int wrong = 0, naive = 0;
        for (int i = 0; i < POINTS; i++) {
            // A way of this slope whose perpendicular from the planet's centre is longer than the radius by the clearance.
            BigDecimal slope = new BigDecimal(-(50 + 100 * random.nextDouble()) / 6.4e6);
            double clearance = (random.nextBoolean() ? 1 : -1) * 3e-10 * (1 + random.nextDouble());
            double height = radius.add(new BigDecimal(clearance))
                    .multiply(slope.pow(2).add(BigDecimal.ONE).sqrt(new MathContext(50))).subtract(radius).doubleValue();
            double far = 300, low = new BigDecimal(height).add(slope.multiply(new BigDecimal(far))).doubleValue();
            Probe probe = new Probe("plane 0 " + height + " 0 0 1 0\nsphere 0 -6.4e6 0 6.4e6");
            assertEquals(0, probe.shoot(new Vector(0, 1, 0), new Vector(0, -1, 0)).shape());
            wrong += probe.seesPoint(new Vector(far, low, 0)) == clearance > 0 ? 0 : 1;
            Vector from = new Vector(0, height + 6.4e6, 0), way = new Vector(far, low - height, 0).unit();
            Vector foot = from.minus(way.times(from.dot(way)));
            naive += 6.4e6 * 6.4e6 < foot.dot(foot) == clearance > 0 ? 0 : 1;
        }
        assertEquals(0, wrong);
        assertTrue(naive > POINTS / 20, naive + " by the plain perpendicular");
    }

    @Test
    @DisplayName("a light on a surface shines on it and off it, without speckles; a plain comparison speckles")
    void lightOnSurface() throws Exception {
        Random random = new Random(4);
        int naive = 0, dark = 0, tried = 0;
        for (int i = 0; i < POINTS; i++) {
            // A plane in any direction, and a light on it as well as doubles can place it; a ball that faces the plane.
            Vector n = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector along = n.cross(new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())).unit();
            Vector q = new Vector(1, 2, 3), light = Naive.point(q, along, random.nextDouble());
            Vector ball = Naive.point(light, n, 5), eye = Naive.point(ball, n, -3);
            Probe probe = new Probe("plane 1 2 3 " + n.x() + " " + n.y() + " " + n.z() + "\nsphere " + ball.x() + " " + ball.y()
                    + " " + ball.z() + " 1");
            Probe.Meeting m = probe.shoot(eye, ball.minus(eye));
            assertTrue(m.shape() == 1, "the ball is seen");
            tried++;
            dark += probe.seesPoint(light) ? 0 : 1;
            Vector way = light.minus(m.point());
            double t = Naive.plane(m.point(), way.unit(), q, n, 1e-9);
            naive += t < way.length() ? 1 : 0;
        }
        assertTrue(tried == POINTS && dark == 0, dark + " points that the light's own surface hides");
        assertTrue(naive > POINTS / 20, naive + " with a plain comparison");
    }

    @Test
    @DisplayName("a light on a triangle likewise")
    void lightOnTriangle() throws Exception {
        Random random = new Random(5);
        for (int i = 0; i < POINTS; i++) {
            Vector a = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            Vector u = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            Vector v = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            Vector b = Naive.point(a, u, 1), c = Naive.point(a, v, 1);
            Vector light = Naive.point(Naive.point(a, u, .1 + .3 * random.nextDouble()), v, .1 + .3 * random.nextDouble());
            Vector ball = Naive.point(light, u.cross(v).unit(), 5), eye = Naive.point(ball, u.cross(v).unit(), -3);
            Probe probe = new Probe("sphere " + ball.x() + " " + ball.y() + " " + ball.z() + " 1\nmaxverts 3\nvertex "
                    + a.x() + " " + a.y() + " " + a.z() + "\nvertex " + b.x() + " " + b.y() + " " + b.z() + "\nvertex "
                    + c.x() + " " + c.y() + " " + c.z() + "\ntri 0 1 2\n");
            assertTrue(probe.shoot(eye, ball.minus(eye)).shape() == 0);
            assertTrue(probe.seesPoint(light), "case " + i);
        }
    }

    @Test
    @DisplayName("a light on a sphere shines along its tangents")
    void lightOnSphere() throws Exception {
        Random random = new Random(7);
        for (int i = 0; i < POINTS; i++) {
            Vector n = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector along = n.cross(new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())).unit();
            Vector light = Naive.point(new Vector(1, 2, 3), n, 2);
            Vector ball = Naive.point(light, along, 5), eye = Naive.point(ball, along, -3);
            Probe probe = new Probe("sphere 1 2 3 2\nsphere " + ball.x() + " " + ball.y() + " " + ball.z() + " 1");
            assertTrue(probe.shoot(eye, ball.minus(eye)).shape() == 1, "the ball is seen");
            assertTrue(probe.seesPoint(light), "case " + i);
        }
    }
}
