package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import raytracer.scene.Colour;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.search.Ties;

/** A ray. */
class MeetingTest {

    private static final Vector FORWARD = new Vector(0, 0, -1);
    private static final String TRIANGLE = "maxverts 3\nvertex 0 0 0\nvertex 3 0 0\nvertex 0 4 0\ntri 0 1 2\n";

    private static Vector at(double x, double y, double z) {
        return new Vector(x, y, z);
    }

    private static LightSource lightAt(double x, double y, double z) {
        return new LightSource(false, x, y, z, new Colour(1, 1, 1));
    }

    @Nested
    @DisplayName("and a sphere")
    class OfSphere {

        @Test
        void meetFirstAtTheNearSide() throws Exception {
            Probe.Meeting m = new Probe("sphere 0 0 -10 2").shoot(at(0, 0, 0), FORWARD);
            assertEquals(new Probe.Meeting(0, 8, at(0, 0, -8), at(0, 0, 1)), m);
        }

        @Test
        void meetAtTheFarSideFromWithin() throws Exception {
            Probe.Meeting m = new Probe("sphere 0 0 0 2").shoot(at(0, 0, 1), FORWARD);
            assertEquals(new Probe.Meeting(0, 3, at(0, 0, -2), at(0, 0, -1)), m);
        }

        @Test
        void doNotMeetBehindOrBeside() throws Exception {
            Probe probe = new Probe("sphere 0 0 10 2\nsphere 5 0 -10 2");
            assertNull(probe.shoot(at(0, 0, 0), FORWARD));
        }

        @Test
        void meetObliquelyWhereGeometrySays() throws Exception {
            // A 3-4-5 triangle: the ray passes 3 beside the centre of a sphere of radius 5.
            Probe.Meeting m = new Probe("sphere 3 0 -10 5").shoot(at(0, 0, 0), FORWARD);
            assertEquals(6, m.distance());
            // Two roundings, of a reciprocal and of a product.
            assertEquals(-3 / 5.0, m.normal().x(), 2 * Rounding.U);
            assertEquals(0, m.normal().y());
            assertEquals(4 / 5.0, m.normal().z(), 2 * Rounding.U);
        }

        @Test
        void meetOnTheFarSideWhenTheRayLeavesItInwards() throws Exception {
            Probe probe = new Probe("sphere 0 0 0 1");
            probe.shoot(at(0, 0, .5), FORWARD);
            assertEquals(2, probe.continueTowards(at(0, 0, 1)).distance(), 1e-15);
            probe.shoot(at(0, 0, .5), FORWARD);
            assertNull(probe.continueTowards(FORWARD));
        }
    }

    @Nested
    @DisplayName("and a plane")
    class OfPlane {

        @Test
        void meetWhereItCrosses() throws Exception {
            Probe.Meeting m = new Probe("plane 7 -2 9 0 3 0").shoot(at(0, 0, 0), at(0, -1, -1));
            assertEquals(2 * Math.sqrt(2), m.distance(), 1e-15);
            assertEquals(at(0, 1, 0), m.normal());
        }

        @Test
        void keepTheNormalAsItIsSeenFromBehind() throws Exception {
            assertEquals(at(0, 1, 0), new Probe("plane 0 2 0 0 1 0").shoot(at(0, 0, 0), at(0, 1, 0)).normal());
        }

        @Test
        void doNotMeetWhenParallelOrBehindOrWithin() throws Exception {
            assertNull(new Probe("plane 0 -1 0 0 1 0").shoot(at(0, 0, 0), FORWARD));
            assertNull(new Probe("plane 0 -1 0 0 1 0").shoot(at(0, 0, 0), at(0, 1, 0)));
            assertNull(new Probe("plane 0 0 0 0 1 0").shoot(at(0, 0, 0), FORWARD));
            assertNull(new Probe("plane 0 0 0 0 1 0").shoot(at(0, 0, 0), at(0, -1, 0)));
        }
    }

    @Nested
    @DisplayName("and a triangle")
    class OfTriangle {

        @Test
        void meetInsideFromBothSidesWithOneNormal() throws Exception {
            Probe probe = new Probe(TRIANGLE);
            assertEquals(new Probe.Meeting(0, 5, at(1, 1, 0), at(0, 0, 1)), probe.shoot(at(1, 1, 5), FORWARD));
            assertEquals(new Probe.Meeting(0, 5, at(1, 1, 0), at(0, 0, 1)), probe.shoot(at(1, 1, -5), at(0, 0, 1)));
        }

        @Test
        void meetOnEdgesAndCornersButNotOutside() throws Exception {
            Probe probe = new Probe(TRIANGLE);
            assertNotNull(probe.shoot(at(1.5, 2, 5), FORWARD));
            assertNotNull(probe.shoot(at(2, 0, 5), FORWARD));
            assertNotNull(probe.shoot(at(0, 4, 5), FORWARD));
            // Beyond what rounding leaves open, which is a few 1e-15 here.
            assertNull(probe.shoot(at(1.5, 2 + 1e-13, 5), FORWARD));
            assertNull(probe.shoot(at(2, -1e-13, 5), FORWARD));
            assertNull(probe.shoot(at(-1e-13, 2, 5), FORWARD));
        }

        @Test
        void doNotMeetEdgeOn() throws Exception {
            assertNull(new Probe(TRIANGLE).shoot(at(1, 10, 0), at(0, -1, 0)));
        }

        @Test
        void doNotMeetIfItHasNoArea() throws Exception {
            Probe probe = new Probe("maxverts 3\nvertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\ntri 0 1 2\ntri 0 0 1\n");
            assertNull(probe.shoot(at(1, 0, 5), FORWARD));
        }
    }

    @Test
    void keepsItsLengthOverAMillionMirrors() {
        Rays rays = new Rays();
        Vector d = at(.3, .5, .8).unit(), n = at(.6, .7, .1).unit(), m = at(-.1, .9, .3).unit();
        rays.count = 1;
        rays.dx[0] = d.x();
        rays.dy[0] = d.y();
        rays.dz[0] = d.z();
        for (int i = 0; i < 1_000_000; i++) {
            Vector normal = i % 2 == 0 ? n : m;
            rays.nx[0] = normal.x();
            rays.ny[0] = normal.y();
            rays.nz[0] = normal.z();
            rays.mirror();
        }
        assertEquals(1, at(rays.dx[0], rays.dy[0], rays.dz[0]).length(), 4 * Rounding.U);
    }

    @Nested
    @DisplayName("that meets several")
    class Ties {

        @Test
        void countsTheNearest() throws Exception {
            assertEquals(1, new Probe("sphere 0 0 -20 1\nsphere 0 0 -10 1\nplane 0 0 -15 0 0 1")
                    .shoot(at(0, 0, 0), FORWARD).shape());
        }

        @Test
        void countsTheFirstDeclaredAtEqualDistance() throws Exception {
            String triangle = TRIANGLE.replace(" 0\n", " -9\n");
            assertEquals(0, new Probe("plane 0 0 -9 0 0 1\n" + triangle + "sphere 1 1 -10 1\n")
                    .shoot(at(1, 1, 0), FORWARD).shape());
            assertEquals(0, new Probe(triangle + "plane 0 0 -9 0 0 1\nsphere 1 1 -10 1\n")
                    .shoot(at(1, 1, 0), FORWARD).shape());
            assertEquals(0, new Probe("sphere 1 1 -10 1\n" + triangle + "plane 0 0 -9 0 0 1\n")
                    .shoot(at(1, 1, 0), FORWARD).shape());
        }
    }

    @Nested
    @DisplayName("to a light")
    class Shadows {

        private Probe onFloor(String blocker) throws Exception {
            Probe probe = new Probe("plane 0 0 0 0 1 0\n" + blocker);
            assertEquals(0, probe.shoot(at(0, .25, 1), at(0, -.25, -1)).shape());
            return probe;
        }

        @Test
        void isBlockedOnlyBetweenPointAndLight() throws Exception {
            for (String blocker : new String[] {"sphere 0 5 0 1", "plane 0 5 0 0 1 0", "maxverts 3\nvertex -9 5 -9\n"
                    + "vertex 9 5 -9\nvertex 0 5 9\ntri 0 1 2\n"}) {
                assertFalse(onFloor(blocker).sees(lightAt(0, 10, 0)), blocker);
                assertTrue(onFloor(blocker).sees(lightAt(0, 3, 0)), blocker);
                assertTrue(onFloor(blocker).sees(lightAt(20, 3, 0)), blocker);
                assertFalse(onFloor(blocker).sees(new LightSource(true, 0, 1, 0, Colour.BLACK)), blocker);
                assertTrue(onFloor(blocker).sees(new LightSource(true, 0, -1, 0, Colour.BLACK)), blocker);
            }
        }

        @Test
        void isNotBlockedByTheSurfaceTheLightIsOn() throws Exception {
            assertTrue(onFloor("sphere 0 6 0 1").sees(lightAt(0, 5, 0)));
            assertFalse(onFloor("sphere 0 6 0 1").sees(lightAt(0, 7, 0)));
            assertTrue(onFloor("plane 0 5 0 0 1 0").sees(lightAt(0, 5, 0)));
        }

        @Test
        void isBlockedByASphereAroundOneEndOnly() throws Exception {
            assertFalse(onFloor("sphere 0 0 0 2").sees(lightAt(0, 5, 0)));
            assertFalse(onFloor("sphere 0 5 0 2").sees(lightAt(0, 5, 0)));
            assertTrue(onFloor("sphere 0 0 0 9").sees(lightAt(0, 5, 0)));
        }

        @Test
        void isBlockedByTheOwnSphereOnlyThroughItsInside() throws Exception {
            Probe probe = new Probe("sphere 0 0 0 1");
            probe.shoot(at(0, 0, 5), FORWARD);
            assertTrue(probe.sees(lightAt(0, 0, 9)));
            assertFalse(probe.sees(lightAt(0, 0, -9)));
            assertTrue(probe.sees(lightAt(0, 0, -.5)));
            assertTrue(probe.sees(lightAt(3, 0, 1)));
        }
    }
}
