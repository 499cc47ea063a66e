package raytracer.chart;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import raytracer.scene.Vector;
import raytracer.tracer.Probe;

/**
 * How a ray that leaves a surface is kept from meeting it again: false shadows (a ray that leaves a sphere outwards meets
 * it) against missed contacts (a ball that touches the point's surroundings is not met). Radii from 10^-3 to 10^3, 0 to
 * 10^6 away from the origin; contacts at 10^-10 to 10^-1 of the radius.
 */
final class LeavingChart {

    private static final int CASES = 40_000;

    /** Per million, if none of the cases is: a rate of more would have shown one (95 %). */
    private static final double NONE = 3e6 / CASES;

    private final String origin;
    private final List<String> csv;

    LeavingChart(String origin, List<String> csv) {
        this.origin = origin;
        this.csv = csv;
    }

    /** Where a ray starts to count, and where it starts. */
    private interface Method {
        /** The distance met on a sphere, NaN for none; {@code n} is the normal at the point left. */
        double meet(Vector point, Vector n, Vector d, Vector centre, double radius);
    }

    void write(Path file) throws Exception {
        Panel panel = new Panel("leaving a sphere, " + CASES + " cases of each kind",
                "false shadows per million; none in " + CASES + " lie at the left",
                "missed contacts per million", NONE);
        for (int e = -12; e <= -3; e++) {
            double epsilon = Math.pow(10, e);
            add(panel, "eps 1e" + e, 0, rates((p, n, d, c, r) -> above(epsilon, p, d, c, r)));
        }
        add(panel, "no epsilon", 1, rates((p, n, d, c, r) -> above(0, p, d, c, r)));
        for (int ulps : new int[] {4, 64}) {
            add(panel, ulps + " ulp offset", 2, rates((p, n, d, c, r) -> above(0, offset(p, n, ulps), d, c, r)));
        }
        add(panel, "error bound", 3, rates((p, n, d, c, r) -> above(bound(p, c, r), p, d, c, r)));
        add(panel, "ours: source rule and bound", 4, ours());
        Figure figure = new Figure("Leaving a surface: false shadows against missed contacts", origin, 1, 720, 460);
        figure.add(panel);
        figure.explain(0, "fixed epsilon");
        figure.explain(1, "no epsilon");
        figure.explain(2, "point moved");
        figure.explain(3, "bound");
        figure.explain(4, "ours");
        figure.explainBand("none missed in " + CASES);
        figure.explainFront("no method here is better both ways");
        Files.writeString(file, figure.svg());
    }

    private void add(Panel panel, String name, int series, double[] rates) {
        double x = Math.max(rates[0], NONE);
        panel.point(name, series, x, x, x, rates[1]);
        csv.add(String.format(Locale.ROOT, "leaving,\"per million: false shadows, missed contacts\",%s,%.1f,,,%d,%.0f,", name, rates[0],
                CASES, rates[1]));
    }

    /** From the textbook: the quadratic formula, roots above a limit. */
    private static double above(double limit, Vector p, Vector d, Vector centre, double radius) {
        Vector x = p.minus(centre);
        double b = x.dot(d), discriminant = b * b - (x.dot(x) - radius * radius);
        if (discriminant < 0) {
            return Double.NaN;
        }
        double near = -b - Math.sqrt(discriminant), far = -b + Math.sqrt(discriminant);
        return near > limit ? near : far > limit ? far : Double.NaN;
    }

    /** Each coordinate moved along the normal by some units in its last place. */
    private static Vector offset(Vector p, Vector n, int ulps) {
        return new Vector(p.x() + Math.signum(n.x()) * ulps * Math.ulp(p.x()),
                p.y() + Math.signum(n.y()) * ulps * Math.ulp(p.y()), p.z() + Math.signum(n.z()) * ulps * Math.ulp(p.z()));
    }

    /** A distance that covers the rounding of the point, from the magnitudes in it. */
    private static double bound(Vector p, Vector centre, double radius) {
        return 64 * 0x1p-53 * (Math.abs(p.x()) + Math.abs(p.y()) + Math.abs(p.z())
                + Math.abs(centre.x()) + Math.abs(centre.y()) + Math.abs(centre.z()) + radius);
    }

    /** One case: a sphere, a point on it, a direction outwards, and a ball that the ray meets after some distance. */
    private static final class Case {
        final double radius;
        final Vector centre;
        final Vector eye;
        final Vector in;
        final Vector out;
        final double gap;

        Case(Random random) {
            radius = Math.pow(10, 6 * random.nextDouble() - 3);
            double away = random.nextInt(4) == 0 ? 0 : Math.pow(10, 7 * random.nextDouble() - 1);
            Vector far = direction(random);
            centre = new Vector(away * far.x(), away * far.y(), away * far.z());
            in = direction(random);
            eye = new Vector(centre.x() - 3 * radius * in.x(), centre.y() - 3 * radius * in.y(), centre.z() - 3 * radius * in.z());
            Vector side = direction(random);
            out = side.dot(in) > 0 ? new Vector(-side.x(), -side.y(), -side.z()) : side;
            // What the coordinates can hold.
            double least = Math.max(1e-10 * radius, 1e3 * Math.ulp(away + radius));
            gap = least * Math.pow(.1 * radius / least, random.nextDouble());
        }

        Vector contact(Vector p) {
            return new Vector(p.x() + (gap + radius) * out.x(), p.y() + (gap + radius) * out.y(), p.z() + (gap + radius) * out.z());
        }
    }

    private static Vector direction(Random random) {
        return new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
    }

    private static double[] rates(Method method) {
        Random random = new Random(1);
        int falseShadows = 0, missed = 0;
        for (int i = 0; i < CASES; i++) {
            Case c = new Case(random);
            double t = above(0, c.eye, c.in, c.centre, c.radius);
            Vector p = new Vector(c.eye.x() + t * c.in.x(), c.eye.y() + t * c.in.y(), c.eye.z() + t * c.in.z());
            Vector n = p.minus(c.centre).unit();
            falseShadows += Double.isNaN(method.meet(p, n, c.out, c.centre, c.radius)) ? 0 : 1;
            double met = method.meet(p, n, c.out, c.contact(p), c.radius);
            // The far side of the ball, or none, is a miss.
            missed += met < c.radius ? 0 : 1;
        }
        return new double[] {1e6 * falseShadows / CASES, 1e6 * missed / CASES};
    }

    private static double[] ours() throws Exception {
        Random random = new Random(1);
        int falseShadows = 0, missed = 0, tried = 0;
        for (int i = 0; i < CASES; i++) {
            Case c = new Case(random);
            String own = "sphere " + c.centre.x() + " " + c.centre.y() + " " + c.centre.z() + " " + c.radius + "\n";
            Probe alone = new Probe(own);
            Vector p = alone.shoot(c.eye, c.in).point();
            falseShadows += alone.continueTowards(c.out) == null ? 0 : 1;
            Vector b = c.contact(p);
            Probe both = new Probe(own + "sphere " + b.x() + " " + b.y() + " " + b.z() + " " + c.radius + "\n");
            // Where the ball hides the point from the eye there is nothing to leave.
            if (both.shoot(c.eye, c.in).shape() == 0) {
                tried++;
                Probe.Meeting m = both.continueTowards(c.out);
                missed += m != null && m.shape() == 1 && m.distance() < c.radius ? 0 : 1;
            }
        }
        return new double[] {1e6 * falseShadows / CASES, 1e6 * missed / tried};
    }
}
