package raytracer.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.RayCounts;

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
