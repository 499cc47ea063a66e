package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import raytracer.exact.Exact;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;

/**
 * A bound on what doubles round by: never below the true error, which is computed in 104 bits, and not a thousand times above it
 * everywhere. Rays start and aim at random, from 1e-6 to 1e6 times as far from the origin as they are long.
 */
class RoundingTest {

    private static final int CASES = 20_000;

    /** What a unit vector's coordinates are off. */
    private static final double UNIT = 2 * Rounding.U;

    private final Random random = new Random(104);

    private record Case(Exact error, double bound) { }

    private interface Cases {

        Case next();
    }

    private static void assertBounds(Cases cases) {
        double max = 0;
        for (int i = 0; i < CASES; i++) {
            Case c = cases.next();
            assertTrue(c.error.abs().compareTo(Exact.of(c.bound)) <= 0, "case " + i + ": " + c);
            max = Math.max(max, c.error.abs().high() / c.bound);
        }
        assertTrue(max > 1e-3, "too wide everywhere: " + max);
    }

    private double magnitude() {
        return Math.pow(10, 12 * random.nextDouble() - 6);
    }

    /** Of some size, or in a special direction. */
    private Vector vector(double size) {
        double x = random.nextDouble() - .5, y = random.nextDouble() - .5, z = random.nextDouble() - .5;
        return switch (random.nextInt(8)) {
            case 0 -> new Vector(size * x, 0, 0);
            case 1 -> new Vector(size * x, size * y * 1e-9, 0);
            default -> new Vector(size * x, size * y, size * z);
        };
    }

    private static Exact[] exact(Vector v) {
        return new Exact[] {Exact.of(v.x()), Exact.of(v.y()), Exact.of(v.z())};
    }

    private static Exact[] minus(Vector a, Vector b) {
        return new Exact[] {Exact.of(a.x()).minus(Exact.of(b.x())), Exact.of(a.y()).minus(Exact.of(b.y())),
            Exact.of(a.z()).minus(Exact.of(b.z()))};
    }

    private static Exact dot(Exact[] a, Exact[] b) {
        return a[0].times(b[0]).plus(a[1].times(b[1])).plus(a[2].times(b[2]));
    }

    private static Exact[] cross(Exact[] a, Exact[] b) {
        return new Exact[] {a[1].times(b[2]).minus(a[2].times(b[1])), a[2].times(b[0]).minus(a[0].times(b[2])),
            a[0].times(b[1]).minus(a[1].times(b[0]))};
    }

    private static Exact[] unit(Vector v) {
        Exact[] e = exact(v);
        Exact length = dot(e, e).root();
        return new Exact[] {e[0].over(length), e[1].over(length), e[2].over(length)};
    }

    @Test
    void ofAPlanesOffset() {
        assertBounds(() -> {
            Vector origin = vector(magnitude()), point = origin.minus(vector(magnitude())), way = vector(1), n = way.unit();
            Vector a = point.minus(origin);
            double offset = a.x() * n.x() + a.y() * n.y() + a.z() * n.z();
            double products = Math.abs(a.x() * n.x()) + Math.abs(a.y() * n.y()) + Math.abs(a.z() * n.z());
            return new Case(dot(minus(point, origin), unit(way)).minus(Exact.of(offset)),
                    Rounding.planeOffset(0, products) + Double.MIN_NORMAL);
        });
    }

    @Test
    void ofACosine() {
        assertBounds(() -> {
            Vector way = vector(magnitude()), normal = vector(magnitude()), d = way.unit(), n = normal.unit();
            return new Case(dot(unit(way), unit(normal)).minus(Exact.of(d.dot(n))), Rounding.cosine(UNIT));
        });
    }

    @Test
    void ofHowFarAlongARayACentreIs() {
        assertBounds(() -> {
            Vector origin = vector(magnitude()), centre = vector(magnitude()), way = vector(1), d = way.unit();
            Vector o = origin.minus(centre);
            return new Case(dot(minus(origin, centre), unit(way)).minus(Exact.of(o.dot(d))),
                    Rounding.along(0, UNIT, o.l1Norm()) + Double.MIN_NORMAL);
        });
    }

    @Test
    void ofHalfAChordsSquareWhereARayGrazesASphere() {
        assertBounds(() -> {
            Vector origin = vector(magnitude()), centre = origin.minus(vector(magnitude())), way = vector(1), d = way.unit();
            Exact[] exactWay = unit(way), exactO = minus(origin, centre);
            Exact alongExact = dot(exactO, exactWay);
            Exact perpendicular = dot(exactO, exactO).minus(alongExact.times(alongExact));
            double r = Math.sqrt(Math.max(0, perpendicular.high())) * (1 + magnitude() * 1e-10);
            Vector o = origin.minus(centre);
            double along = o.dot(d);
            Vector e = o.minus(d.times(along));
            Exact error = Exact.of(r).times(r).minus(perpendicular).minus(Exact.of(r * r - e.dot(e)));
            return new Case(error, Rounding.sphereSquare(0, UNIT, o.l1Norm(), r, along) + Double.MIN_NORMAL);
        });
    }

    @Test
    void ofAnEdgesSide() {
        assertBounds(() -> {
            Vector origin = vector(magnitude()), first = origin.minus(vector(magnitude()));
            Vector second = first.minus(vector(magnitude()));
            // As near to the edge as it is long: where a ray passes farther away, its side is beyond doubt.
            Vector way = first.minus(first.minus(second).times(random.nextDouble())).minus(origin)
                    .minus(vector(first.minus(second).l1Norm())), d = way.unit();
            Vector a = first.minus(origin), b = second.minus(origin), edge = b.minus(a), sum = a.minus(b.times(-1));
            double side = d.dot(edge.cross(sum));
            Exact exact = dot(unit(way), cross(minus(first, origin), minus(second, origin))).times(-2);
            return new Case(exact.minus(Exact.of(side)), Rounding.edge(0, UNIT, Math.max(a.l1Norm(), b.l1Norm()), edge.l1Norm())
                    + Double.MIN_NORMAL);
        });
    }

    @Test
    void ofAPointsDistanceFromItsRay() {
        assertBounds(() -> {
            Vector origin = vector(magnitude()), way = vector(1), d = way.unit();
            double t = magnitude();
            Vector point = new Vector(origin.x() + t * d.x(), origin.y() + t * d.y(), origin.z() + t * d.z());
            Exact[] beside = cross(minus(point, origin), unit(way));
            return new Case(dot(beside, beside).root(), Rounding.point(t, point.l1Norm()));
        });
    }
}
