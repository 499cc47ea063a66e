package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.exact.ExactKernels;
import raytracer.scene.Vector;
import raytracer.tracer.Probe;

/** Planes and boxes hold where fixed limits and NaN fail. */
class PlaneAndBoxStabilityTest {

    @ParameterizedTest(name = "a floor is seen {0} away from height 1")
    @ValueSource(doubles = {1, 1e3, 1e6, 1e7, 1e9, 1e12, 1e14})
    void floor(double distance) throws Exception {
        Probe probe = new Probe("plane 0 0 0 0 1 0");
        Vector eye = new Vector(0, 1, 0), d = new Vector(distance, -1, 0).unit(), up = new Vector(0, 1, 0);
        Probe.Meeting m = probe.shoot(eye, d);
        double truth = ExactKernels.plane(eye, d, new Vector(0, 0, 0), up);
        assertEquals(truth, m.distance(), 1e-15 * truth);
        boolean lost = Double.isNaN(Naive.plane(eye, d, new Vector(0, 0, 0), up, 1e-6));
        assertEquals(distance >= 1e6, lost, "lost by |d.n| < 1e-6");
    }

    @Test
    @DisplayName("a ray that is parallel as far as doubles can tell meets nothing; a test for 0 makes horizons of rounding")
    void parallel() throws Exception {
        Random random = new Random(1);
        int naive = 0;
        for (int i = 0; i < 1000; i++) {
            Vector n = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vector d = n.cross(new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())).unit();
            Vector o = Naive.point(new Vector(1, 2, 3), n, random.nextBoolean() ? 1 : -1);
            assertNull(new Probe("plane 1 2 3 " + n.x() + " " + n.y() + " " + n.z()).shoot(o, d));
            naive += Naive.plane(o, d, new Vector(1, 2, 3), n, 0) > 0 ? 1 : 0;
        }
        assertTrue(naive > 200, naive + " of 1000 met at distances about 1e16");
    }

    @Test
    @DisplayName("a ray within a box's side plane meets what lies there; slabs with NaN lose it")
    void slabs() throws Exception {
        // A grid of flat squares in the plane x = 1, seen along that plane's edge and along axes with either zero.
        StringBuilder text = new StringBuilder("maxverts 4000\n");
        int n = 0;
        for (int i = 0; i < 20; i++) {
            for (int j = 0; j < 20; j++) {
                for (int[] c : new int[][] {{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                    text.append("vertex ").append(i + c[0]).append(" 0 ").append(j + c[1]).append('\n');
                }
                text.append("tri ").append(n).append(' ').append(n + 1).append(' ').append(n + 2).append('\n');
                text.append("tri ").append(n).append(' ').append(n + 2).append(' ').append(n + 3).append('\n');
                n += 4;
            }
        }
        Probe probe = new Probe(text.toString());
        int naive = 0;
        for (int i = 0; i <= 20; i++) {
            for (int j = 0; j <= 20; j++) {
                for (double zero : new double[] {0.0, -0.0}) {
                    // Straight down on a corner: the origin is on side planes of the boxes around, and d is 0 there.
                    Vector o = new Vector(i, 5, j), d = new Vector(zero, -1, zero);
                    Probe.Meeting m = probe.shoot(o, d);
                    assertNotNull(m, "corner " + i + " " + j);
                    assertEquals(5, m.distance());
                    naive += Naive.box(o, d, new double[] {i, 0, j, i + 1, 0, j + 1}) ? 0 : 1;
                }
            }
        }
        assertTrue(naive > 400, naive + " of 882 boxes lost to NaN");
    }
}
