package raytracer.tracer.surface;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.RayIntervals;

/** A batch's lines. */
class LineBundleTest {

    private static final int LINES = 100;
    private static final int TRIANGLES = 2000;

    private final Random random = new Random(3);
    private final Vectors origin = new Vectors(), direction = new Vectors();
    private final RayIntervals intervals = new RayIntervals();
    private final LineBundle lines = new LineBundle();

    private Vector vector(double size) {
        return new Vector(size * (random.nextDouble() - .5), size * (random.nextDouble() - .5), size * (random.nextDouble() - .5));
    }

    private static void set(Vectors vectors, int i, Vector v) {
        vectors.x()[i] = v.x();
        vectors.y()[i] = v.y();
        vectors.z()[i] = v.z();
    }

    private static void enclose(Vectors vectors, double[] min, double[] max) {
        double[][] v = {vectors.x(), vectors.y(), vectors.z()};
        for (int axis = 0; axis < 3; axis++) {
            min[axis] = Double.POSITIVE_INFINITY;
            max[axis] = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < LINES; i++) {
                min[axis] = Math.min(min[axis], v[axis][i]);
                max[axis] = Math.max(max[axis], v[axis][i]);
            }
        }
    }

    /** Lines from places that are spread by some size towards others, about 5 sizes away; every other one to an edge. */
    private void aim(String kind, double size, Vector centre, Vector a, Vector b) {
        Vector way = new Vector(0, .6, -.8);
        for (int i = 0; i < LINES; i++) {
            Vector to = i % 2 == 0 ? a.minus(a.minus(b).times(random.nextDouble()))
                    : centre.minus(new Vector(0, 0, 5 * size)).minus(vector(size));
            Vector from = kind.equals("meeting") ? centre : kind.equals("parallel") ? to.minus(way.times((4 + random.nextDouble()) * size))
                    : centre.minus(vector(size));
            set(origin, i, from);
            set(direction, i, kind.equals("parallel") ? way : to.minus(from).unit());
        }
        switch (kind) {
            case "meeting" -> lines.setMeeting(centre, origin, direction, 0, LINES);
            case "parallel" -> lines.setParallel(way, origin, 0, LINES);
            default -> lines.setSkew(origin, direction, 0, LINES);
        }
        lines.setErrors(0, 2 * Rounding.U);
        enclose(origin, intervals.minOrigin, intervals.maxOrigin);
        enclose(direction, intervals.minDirection, intervals.maxDirection);
    }

    /** The least of the sides on which line i passes three edges, if it passes all on one side; else negative. */
    private double depth(int i, Vector a, Vector b, Vector c) {
        Vector o = origin.get(i), d = direction.get(i), p = a.minus(o), q = b.minus(o), r = c.minus(o);
        double ab = d.dot(p.cross(q)), bc = d.dot(q.cross(r)), ca = d.dot(r.cross(p));
        return Math.max(Math.min(ab, Math.min(bc, ca)), Math.min(-ab, Math.min(-bc, -ca)));
    }

    @ParameterizedTest(name = "{0} ones of size {1}: a line that passes a triangle is never clear of it, and most others are")
    @CsvSource({"meeting, 1", "parallel, 1", "skew, 1", "meeting, 1e140", "parallel, 1e140", "skew, 1e140", "meeting, 1e-140",
        "parallel, 1e-140", "skew, 1e-140"})
    void clearsOnlyWhatPassesBy(String kind, double size) {
        int passing = 0, cleared = 0, missing = 0, sifted = 0;
        for (int n = 0; n < TRIANGLES; n++) {
            Vector centre = vector(10 * size);
            Vector middle = centre.minus(vector(3 * size)).minus(new Vector(0, 0, 5 * size));
            Vector a = middle.minus(vector(size)), b = middle.minus(vector(size)), c = middle.minus(vector(size));
            aim(kind, size, centre, a, b);
            double edges = b.minus(a).l1Norm() + c.minus(a).l1Norm();
            boolean mayHit = true;
            if (lines.areAlike()) {
                lines.setIntervals(intervals);
                mayHit = lines.mayHit(a, b, c, edges);
                Vector aside = new Vector(9 * size, 0, 0);
                sifted += lines.mayHit(a.minus(aside), b.minus(aside), c.minus(aside), edges) ? 0 : 1;
            }
            float clear = lines.measure(a, b, c, edges, 0, LINES);
            for (int i = 0; i < LINES; i++) {
                // Within what doubles round by, it is on an edge.
                if (depth(i, a, b, c) >= -1e-14 * size * size) {
                    passing++;
                    assertTrue(mayHit);
                    assertFalse(lines.clearance[i] > clear, kind + " " + n + " " + i);
                } else {
                    missing++;
                    cleared += lines.clearance[i] > clear ? 1 : 0;
                }
            }
        }
        assertTrue(passing > LINES * TRIANGLES / 200, passing + " pass");
        assertTrue(cleared > .99 * missing, cleared + " of " + missing + " are cleared");
        assertTrue(kind.equals("skew") || sifted > .9 * TRIANGLES, sifted + " are sifted");
    }
}
