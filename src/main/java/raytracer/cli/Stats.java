package raytracer.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;
import raytracer.tracer.TreeFacts;

/** The figures of one job, gathered as it goes. */
final class Stats {

    private final String file;
    private final int threads;

    double parseMillis;
    double buildMillis;
    final List<Double> renderMillis = new ArrayList<>();
    double writeMillis;
    RayCounts rays = RayCounts.ZERO;

    Stats(String file, int threads) {
        this.file = file;
        this.threads = threads;
    }

    String json(Scene scene) {
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
                  "lights": %d
                }
                """, quoted(file), scene.width(), scene.height(), threads, millis(parseMillis), millis(buildMillis),
                repeats, millis(writeMillis), rays.primary(), rays.shadow(), rays.reflection(),
                scene.mesh().triangles(), count(scene, Shape.Sphere.class), count(scene, Shape.Plane.class),
                scene.lights().size());
    }

    /** What was parsed and built. */
    String sceneInWords(Scene scene, Tracer tracer) {
        StringBuilder words = new StringBuilder(String.format(Locale.ROOT,
                "parsed in %.0f ms: %d spheres, %d planes, %d triangles, %d lights, maxdepth %d%n", parseMillis,
                count(scene, Shape.Sphere.class), count(scene, Shape.Plane.class), scene.mesh().triangles(),
                scene.lights().size(), scene.maxDepth()));
        for (TreeFacts tree : tracer.trees()) {
            words.append(String.format(Locale.ROOT,
                    "tree of %d %s: %d nodes, depth %d, %.1f MB; %d more are too wide for it%n", tree.things(),
                    tree.kind(), tree.nodes(), tree.depth(), tree.bytes() / 1e6, tree.beside()));
        }
        words.append(String.format(Locale.ROOT, "built in %.0f ms, %d threads%n", buildMillis, threads));
        return words.toString();
    }

    /** How fast it went. */
    String timesInWords() {
        double seconds = renderMillis.get(renderMillis.size() - 1) / 1e3;
        Runtime java = Runtime.getRuntime();
        return String.format(Locale.ROOT,
                "traced in %.0f ms: %d rays from the eye, %d to lights, %d from mirrors; %.1f Mrays/s%n"
                        + "written %.0f ms later; %d MB of memory in use, %d MB allowed%n",
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
