package raytracer.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import raytracer.console.Stopwatch;
import raytracer.files.Reference;
import raytracer.image.Comparison;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;
import raytracer.tracer.bvh.TreeFacts;

/** The figures of one job, gathered as it goes. */
final class Stats {

    final Stopwatch whole = new Stopwatch();
    double parseMillis;
    double buildMillis;
    final List<Double> renderMillis = new ArrayList<>();
    double writeMillis;
    RayCounts rays = RayCounts.ZERO;
    int samples;

    /** What every job's figures begin with. */
    static Map<String, Object> head(String file) {
        Map<String, Object> figures = new LinkedHashMap<>();
        figures.put("program", version());
        figures.put("java", Runtime.version().toString());
        figures.put("scene", file);
        return figures;
    }

    /** How a picture compares. */
    static Map<String, Object> compared(Path reference, Reference.Verdict verdict) {
        Map<String, Object> figures = new LinkedHashMap<>();
        Comparison c = verdict.comparison();
        figures.put("reference", reference.toString());
        figures.put("differing", c == null ? null : c.pixels());
        figures.put("beyond", c == null ? null : c.beyond());
        figures.put("most", c == null ? null : c.max());
        figures.put("rmse", c == null ? null : c.rmse());
        figures.put("x", c == null ? null : c.x());
        figures.put("y", c == null ? null : c.y());
        return figures;
    }

    Map<String, Object> figures(String file, Scene scene, int threads) {
        Map<String, Object> figures = head(file), traced = new LinkedHashMap<>();
        traced.put("primary", rays.primary());
        traced.put("shadow", rays.shadow());
        traced.put("reflection", rays.reflection());
        figures.put("width", scene.width());
        figures.put("height", scene.height());
        figures.put("threads", threads);
        figures.put("samples", samples);
        figures.put("parseMillis", parseMillis);
        figures.put("buildMillis", buildMillis);
        figures.put("renderMillis", renderMillis);
        figures.put("writeMillis", writeMillis);
        figures.put("rays", traced);
        figures.put("triangles", scene.mesh().triangles());
        figures.put("spheres", count(scene, Shape.Sphere.class));
        figures.put("planes", count(scene, Shape.Plane.class));
        figures.put("lights", scene.lights().size());
        return figures;
    }

    /** What a scene holds. */
    static String inWords(Scene scene) {
        return counted(count(scene, Shape.Sphere.class), "sphere") + ", "
                + counted(count(scene, Shape.Plane.class), "plane") + ", "
                + counted(scene.mesh().triangles(), "triangle") + ", " + counted(scene.lights().size(), "light")
                + ", maxdepth " + scene.maxDepth() + (scene.shadow() ? "" : ", no shadows");
    }

    static String counted(long count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }

    /** What was parsed and built. */
    String sceneInWords(Scene scene, Tracer tracer) {
        StringBuilder words = new StringBuilder(
                String.format(Locale.ROOT, "parsed in %.0f ms: %s%n", parseMillis, inWords(scene)));
        for (TreeFacts tree : tracer.trees()) {
            if (tree.primitives() > 0) {
                words.append(String.format(Locale.ROOT, "tree of %d %s: %s, depth %d, %.1f MB%n", tree.primitives(),
                        tree.kind(), counted(tree.nodes(), "node"), tree.depth(), tree.bytes() / 1e6));
            }
            if (tree.oversized() > 0) {
                words.append(counted(tree.oversized(), tree.kind().substring(0, tree.kind().length() - 1))
                        + " too wide for a tree\n");
            }
        }
        return words.append(String.format(Locale.ROOT, "built in %.0f ms", buildMillis)).toString();
    }

    /** How many rays were traced; of few, the exact number. */
    String raysInWords() {
        return rays.total() < 100_000 ? counted(rays.total(), "ray") : tenths(rays.total() / 1e6) + " Mrays";
    }

    /** With one decimal. */
    static String tenths(double value) {
        return String.valueOf(Math.round(10 * value) / 10.0);
    }

    /** How fast it went. */
    String timesInWords() {
        double seconds = renderMillis.get(renderMillis.size() - 1) / 1e3;
        Runtime java = Runtime.getRuntime();
        return String.format(Locale.ROOT,
                "traced in %.0f ms, %s a pixel: %d rays from the eye, %d to lights, %d from mirrors; %.1f Mrays/s%n"
                        + "written in %.0f ms; %d MB of memory in use, %d MB allowed",
                seconds * 1e3, counted(samples, "sample"), rays.primary(), rays.shadow(), rays.reflection(),
                rays.total() / seconds / 1e6, writeMillis, java.totalMemory() - java.freeMemory() >> 20, java.maxMemory() >> 20);
    }

    private static long count(Scene scene, Class<? extends Shape> kind) {
        return scene.shapes().stream().filter(kind::isInstance).count();
    }

    static String version() {
        String version = Stats.class.getPackage().getImplementationVersion();
        return version == null ? "(development)" : version;
    }
}
