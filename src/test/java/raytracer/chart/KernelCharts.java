package raytracer.chart;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.Supplier;
import raytracer.exact.ExactKernels;
import raytracer.scene.Vector;
import raytracer.tracer.KernelAccess;

/** Kernels against one another: time against wrong answers, and time against the error of the distance, by regime. */
final class KernelCharts {

    /** Rays of one batch: their data stay in the L2 cache. */
    private static final int BATCH = 2048;
    private static final int BATCHES = 150;
    private static final int RAYS = BATCH * BATCHES;

    private final String origin;
    private final List<String> csv;

    /** @param origin of the figures: machine, Java, commit and date */
    KernelCharts(String origin, List<String> csv) {
        this.origin = origin;
        this.csv = csv;
    }

    /** A method to be timed on one batch; what it leaves are its distances. */
    private record Method(String name, Timing.Work work, Supplier<double[]> distances) { }

    /** A regime whose answers are known and whose times are not yet. */
    private record Judged(String chart, String regime, List<Method> methods, List<Verdict> verdicts) { }

    private final List<Judged> waiting = new ArrayList<>();

    /** A set of rays, and what they meet exactly; methods are made for each batch anew. */
    private interface Regime {
        List<Method> batch(Random random, double[] truth) throws Exception;
    }

    void spheres(Path file) throws Exception {
        Figure figure = new Figure("Sphere kernels: speed against accuracy", origin, 2, 380, 250);
        addSpheres("ordinary: radius 1, 3 to 30 away", random -> ball(random, 1, 3 + 27 * random.nextDouble(), 1.3, 0));
        addSpheres("far: radius 1, 10^6 to 10^8 away",
                random -> ball(random, 1, Math.pow(10, 6 + 2 * random.nextDouble()), 1.3, 0));
        addSpheres("huge: radius 10^4 to 10^9, eye at height .001 to 1", KernelCharts::ground);
        addSpheres("edge-aimed: past the rim by 10^-12 to 10^-3 radii",
                random -> ball(random, 1, 3 + 27 * random.nextDouble(), 1, 1e-3));
        finish(figure);
        Files.writeString(file, figure.svg());
    }

    /** A sphere, a ray, and in the fourth place the radius. */
    private static Vector[] ball(Random random, double radius, double distance, double spread, double rim) {
        Vector way = direction(random);
        Vector centre = times(way, distance);
        Vector side = way.cross(direction(random)).unit();
        double clearance = Math.pow(10, Math.log10(rim) - 9 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
        double beside = radius * (rim > 0 ? 1 + clearance : spread * Math.sqrt(random.nextDouble()));
        // Past the centre by exactly so much: a right angle at the point passed.
        double sine = beside / distance;
        Vector d = plus(times(way, Math.sqrt(1 - sine * sine)), side, sine).unit();
        return new Vector[] {new Vector(0, 0, 0), d, centre, new Vector(radius, 0, 0)};
    }

    private static Vector[] ground(Random random) {
        double radius = Math.pow(10, 4 + 5 * random.nextDouble()), height = Math.pow(10, -3 * random.nextDouble());
        Vector d = new Vector(random.nextGaussian(), -.2 - random.nextDouble(), random.nextGaussian()).unit();
        return new Vector[] {new Vector(0, height, 0), d, new Vector(0, -radius, 0), new Vector(radius, 0, 0)};
    }

    private static Vector direction(Random random) {
        return new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
    }

    private static Vector times(Vector v, double f) {
        return new Vector(v.x() * f, v.y() * f, v.z() * f);
    }

    /** a + part b. */
    private static Vector plus(Vector a, Vector b, double part) {
        return new Vector(a.x() + part * b.x(), a.y() + part * b.y(), a.z() + part * b.z());
    }

    private interface SphereRay {
        Vector[] next(Random random);
    }

    private void addSpheres(String name, SphereRay rays) throws Exception {
        judge("spheres", name, (random, truth) -> {
            Vector[] o = new Vector[BATCH], d = new Vector[BATCH], c = new Vector[BATCH];
            double[] r = new double[BATCH];
            int[] own = new int[BATCH];
            StringBuilder shapes = new StringBuilder();
            for (int i = 0; i < BATCH; i++) {
                Vector[] v = rays.next(random);
                o[i] = v[0];
                d[i] = v[1];
                c[i] = v[2];
                r[i] = v[3].x();
                own[i] = i;
                truth[i] = ExactKernels.sphere(o[i], d[i], c[i], r[i]);
                shapes.append("sphere " + c[i].x() + " " + c[i].y() + " " + c[i].z() + " " + r[i] + "\n");
            }
            SphereMethods textbook = new SphereMethods(o, d, c, r);
            KernelAccess ours = new KernelAccess(shapes.toString(), o, d, own);
            return List.of(
                    new Method("float", textbook::inFloat, textbook.t::clone),
                    new Method("quadratic", textbook::quadratic, textbook.t::clone),
                    new Method("perpendicular", textbook::perpendicular, textbook.t::clone),
                    new Method("ours", ours::run, ours::distances));
        });
    }

    void triangles(Path file) throws Exception {
        Figure figure = new Figure("Triangle kernels: speed against accuracy", origin, 2, 380, 250);
        addTriangles("ordinary: legs about 1, 3 to 30 away", 1, 10, false);
        addTriangles("far: legs about 1, 10^6 to 10^7 away", 1, 3e6, false);
        addTriangles("small: legs about 10^-6, seen from 10^-5", 1e-6, 10, false);
        addTriangles("edge-aimed: at an edge that two triangles share", 1, 10, true);
        finish(figure);
        Files.writeString(file, figure.svg());
    }

    private void addTriangles(String name, double size, double distance, boolean edge) throws Exception {
        judge("triangles", name, (random, truth) -> {
            Vector[] o = new Vector[BATCH], d = new Vector[BATCH];
            Vector[] first = new Vector[3 * BATCH], second = new Vector[3 * BATCH];
            int[] one = new int[BATCH], other = new int[BATCH];
            StringBuilder shapes = new StringBuilder("maxverts " + 6 * BATCH + "\n");
            StringBuilder corners = new StringBuilder();
            for (int i = 0; i < BATCH; i++) {
                Vector a = times(direction(random), size), b = times(direction(random), size), c = times(direction(random), size);
                Vector across = plus(a, b.minus(c), 1);
                Vector target = edge ? plus(a, b.minus(a), random.nextDouble())
                        : plus(plus(a, b.minus(a), 1.2 * random.nextDouble() - .1), c.minus(a), random.nextDouble() - .1);
                o[i] = times(direction(random), size * distance * Math.pow(10, random.nextDouble() - .5));
                d[i] = target.minus(o[i]).unit();
                Vector[] pair = {a, b, c, b, a, across};
                for (int k = 0; k < 6; k++) {
                    corners.append("vertex " + pair[k].x() + " " + pair[k].y() + " " + pair[k].z() + "\n");
                    (k < 3 ? first : second)[3 * i + k % 3] = pair[k];
                }
                one[i] = 2 * i;
                other[i] = 2 * i + 1;
                truth[i] = ExactKernels.triangle(o[i], d[i], a, b, c);
                if (edge) {
                    double distanceAcross = ExactKernels.triangle(o[i], d[i], b, a, across);
                    truth[i] = Double.isNaN(truth[i]) ? distanceAcross : truth[i];
                }
            }
            for (int v = 0; v < 6 * BATCH; v += 3) {
                corners.append("tri " + v + " " + (v + 1) + " " + (v + 2) + "\n");
            }
            shapes.append(corners);
            TriangleMethods near = new TriangleMethods(o, d, first), far = new TriangleMethods(o, d, second);
            KernelAccess ours = new KernelAccess(shapes.toString(), o, d, one);
            KernelAccess oursAcross = new KernelAccess(shapes.toString(), o, d, other);
            List<Method> methods = new ArrayList<>();
            methods.add(new Method("float", near::inFloat, () -> either(edge, near, far::inFloat, far)));
            for (double epsilon : new double[] {1e-6, 1e-9, 0}) {
                methods.add(new Method(String.format(Locale.ROOT, "Moeller-Trumbore, eps %s", epsilon == 0 ? "0" : epsilon == 1e-6 ? "1e-6" : "1e-9"),
                        () -> near.inDouble(epsilon), () -> either(edge, near, () -> far.inDouble(epsilon), far)));
            }
            methods.add(new Method("ours", ours::run, () -> {
                oursAcross.run();
                return edge ? either(ours.distances(), oursAcross.distances()) : ours.distances();
            }));
            return methods;
        });
    }

    private static double[] either(boolean edge, TriangleMethods near, Timing.Work farWork, TriangleMethods far) {
        if (!edge) {
            return near.t.clone();
        }
        farWork.run();
        return either(near.t, far.t);
    }

    private static double[] either(double[] a, double[] b) {
        double[] t = a.clone();
        for (int i = 0; i < t.length; i++) {
            t[i] = Double.isNaN(a[i]) ? b[i] : a[i];
        }
        return t;
    }

    /** A regime's answers are judged at once; its last batch waits to be timed with all others. */
    private void judge(String chart, String name, Regime regime) throws Exception {
        Random random = new Random(1);
        double[] truth = new double[RAYS];
        List<double[]> answers = new ArrayList<>();
        List<Method> methods = List.of();
        for (int batch = 0; batch < BATCHES; batch++) {
            double[] exact = new double[BATCH];
            methods = regime.batch(random, exact);
            System.arraycopy(exact, 0, truth, batch * BATCH, BATCH);
            for (int k = 0; k < methods.size(); k++) {
                if (batch == 0) {
                    answers.add(new double[RAYS]);
                }
                methods.get(k).work.run();
                System.arraycopy(methods.get(k).distances.get(), 0, answers.get(k), batch * BATCH, BATCH);
            }
        }
        List<Verdict> verdicts = answers.stream().map(a -> Verdict.of(a, truth)).toList();
        waiting.add(new Judged(chart, name, methods, verdicts));
    }

    /** Times all regimes that wait, in turns, and draws them. */
    private void finish(Figure figure) {
        List<Timing.Work> works = waiting.stream().flatMap(j -> j.methods.stream()).map(Method::work).toList();
        Timing[] timings = Timing.of(works, BATCH, 1000, 501);
        int next = 0;
        for (Judged judged : waiting) {
            next = draw(figure, judged, timings, next);
        }
        waiting.clear();
        figure.explain(4, "ours");
        figure.explainBars("quartiles");
        figure.explainBand("none wrong in " + RAYS);
        figure.explainFront("no method measured is faster and as accurate");
    }

    private int draw(Figure figure, Judged judged, Timing[] timings, int first) {
        Panel wrong = new Panel(judged.regime, "ns per ray", "wrong per million", 3e6 / RAYS);
        Panel error = new Panel(judged.regime, "ns per ray" + withoutAnswer(judged), "error of t, 99.9 %", 0);
        for (int k = 0; k < judged.methods.size(); k++) {
            Verdict verdict = judged.verdicts.get(k);
            Timing timing = timings[first + k];
            String name = judged.methods.get(k).name;
            int series = name.equals("ours") ? 4 : k % 4;
            wrong.point(name, series, timing.median(), timing.low(), timing.high(), verdict.wrongPerMillion());
            if (!Double.isNaN(verdict.p999())) {
                error.point(name, series, timing.median(), timing.low(), timing.high(), verdict.p999());
            }
            csv.add(String.format(Locale.ROOT, "%s,\"%s\",%s,%.2f,%.2f,%.2f,%d,%d,%.3g", judged.chart, judged.regime,
                    name.replace(",", ""), timing.median(), timing.low(), timing.high(), verdict.count(), verdict.wrong(),
                    verdict.p999()));
        }
        figure.add(wrong);
        figure.add(error);
        return first + judged.methods.size();
    }

    /** How many methods have no answer for so many rays that their error cannot be told; nothing if none. */
    private static String withoutAnswer(Judged judged) {
        long count = judged.verdicts.stream().filter(verdict -> Double.isNaN(verdict.p999())).count();
        return count == 0 ? "" : "; " + count + " without an answer for many rays";
    }
}
