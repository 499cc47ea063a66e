package raytracer.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
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

    private final String file;
    private final int threads;

    final Stopwatch whole = new Stopwatch();
    double parseMillis;
    double buildMillis;
    final List<Double> renderMillis = new ArrayList<>();
    double writeMillis;
    RayCounts rays = RayCounts.ZERO;

    Stats(String file, int threads) {
        this.file = file;
        this.threads = threads;
    }

    /** Of two pictures that were compared. */
    static String json(String file, Path reference, Reference.Verdict verdict, int width, int height) {
        return String.format(Locale.ROOT, "{\n  \"scene\": %s,\n  \"width\": %d,\n  \"height\": %d%s\n}\n",
                quoted(file), width, height, compared(reference, verdict));
    }

    /** How a picture compares; nothing if the verdict is null. */
    private static String compared(Path reference, Reference.Verdict verdict) {
        if (verdict == null) {
            return "";
        }
        Comparison c = verdict.comparison();
        String figures = c == null
                ? "\"differing\": null, \"beyond\": null, \"most\": null, \"rmse\": null, \"x\": null, \"y\": null"
                : String.format(Locale.ROOT,
                        "\"differing\": %d, \"beyond\": %d, \"most\": %d, \"rmse\": %.4f, \"x\": %d, \"y\": %d",
                        c.pixels(), c.beyond(), c.max(), c.rmse(), c.x(), c.y());
        return ",\n  \"compare\": {\"reference\": " + quoted(reference.toString()) + ", " + figures + "}";
    }

    /** @param verdict null if the picture was not compared */
    String json(Scene scene, Path reference, Reference.Verdict verdict) {
        String repeats = renderMillis.stream().map(Stats::millis).collect(Collectors.joining(", "));
        return String.format(Locale.ROOT, """
                {
                  "scene": %s,
                  "width": %d,
                  "height": %d,
                  "threads": %d,
                  "parseMillis": %s,
                  "buildMillis": %s,
                  "renderMillis": [%s],
                  "writeMillis": %s,
                  "rays": {"primary": %d, "shadow": %d, "reflection": %d},
                  "triangles": %d,
                  "spheres": %d,
                  "planes": %d,
                  "lights": %d%s
                }
                """, quoted(file), scene.width(), scene.height(), threads, millis(parseMillis), millis(buildMillis),
                repeats, millis(writeMillis), rays.primary(), rays.shadow(), rays.reflection(),
                scene.mesh().triangles(), count(scene, Shape.Sphere.class), count(scene, Shape.Plane.class),
                scene.lights().size(), compared(reference, verdict));
    }

    /** What a scene holds. */
    static String inWords(Scene scene) {
        return counted(count(scene, Shape.Sphere.class), "sphere") + ", "
                + counted(count(scene, Shape.Plane.class), "plane") + ", "
                + counted(scene.mesh().triangles(), "triangle") + ", " + counted(scene.lights().size(), "light")
                + ", maxdepth " + scene.maxDepth();
    }

    private static String counted(long count, String thing) {
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
                "traced in %.0f ms: %d rays from the eye, %d to lights, %d from mirrors; %.1f Mrays/s%n"
                        + "written in %.0f ms; %d MB of memory in use, %d MB allowed",
                seconds * 1e3, rays.primary(), rays.shadow(), rays.reflection(), rays.total() / seconds / 1e6,
                writeMillis, java.totalMemory() - java.freeMemory() >> 20, java.maxMemory() >> 20);
    }

    private static long count(Scene scene, Class<? extends Shape> kind) {
        return scene.shapes().stream().filter(kind::isInstance).count();
    }

    private static String millis(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }

    private static String quoted(String text) {
        StringBuilder out = new StringBuilder("\"");
        for (char c : text.toCharArray()) {
            if (c == '"' || c == '\\') {
                out.append('\\').append(c);
            } else if (c < ' ') {
                out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            } else {
                out.append(c);
            }
        }
        return out.append('"').toString();
    }
}
