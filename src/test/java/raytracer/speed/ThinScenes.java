package raytracer.speed;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;

/** Scenes of things that are thinner than a pixel, or end in it, 240 x 180: what a sampler may overlook. */
final class ThinScenes {

    private static final String SIZE = "size 240 180\n";
    private static final String FRONT = SIZE + "camera 0 0 10 0 0 0 0 1 0 45\n";

    private final Random random = new Random(7);
    private final List<String> vertices = new ArrayList<>();
    private final List<String> triangles = new ArrayList<>();

    private ThinScenes() { }

    static Map<String, String> all() {
        Map<String, String> all = new LinkedHashMap<>();
        all.put("60 needles, 0.1 to 0.5 pixels wide", new ThinScenes().needles());
        all.put("500 spheres of 0.1 to 0.5 pixels", FRONT + "ambient .9 .9 .9\n" + new ThinScenes().spheres(500, 3.5, .003, .012));
        all.put("a fence of 110 slanted slats, half a pixel wide", new ThinScenes().fence());
        all.put("stripes to the horizon", new ThinScenes().horizon());
        all.put("shadows of 40 slats, a tenth of a pixel wide", new ThinScenes().shadows());
        all.put("200 small mirrors", FRONT + "maxdepth 4\npoint 4 5 8 .8 .8 .8\nambient .2 .1 .05\ndiffuse .3 .3 .5\n"
                + "specular .7 .7 .7\nshininess 40\n" + new ThinScenes().spheres(200, 3, .02, .08));
        all.put("highlights of shininess 200,000", highlights());
        all.put("triangles that meet in T-junctions", junctions());
        all.put("a bumpy mesh, 8 triangles a pixel", new ThinScenes().farMesh());
        all.put("mirrors in mirrors", SIZE + "maxdepth 8\ncamera 0 0 5 0 0 0 0 1 0 50\npoint 0 2 4 .8 .8 .8\nambient .05 .05 .05\n"
                + "diffuse .2 .2 .2\nspecular .8 .8 .8\nshininess 60\nsphere -1.1 0 0 1\nsphere 1.1 0 0 1\nsphere 0 1.8 0 1\n"
                + "plane 0 -1.2 0 0 1 0\ndiffuse .5 .3 .1\nspecular 0 0 0\nplane 0 0 -3 0 0 1\n");
        return all;
    }

    private double between(double a, double b) {
        return a + (b - a) * random.nextDouble();
    }

    private int vertex(double x, double y, double z) {
        vertices.add(String.format(Locale.ROOT, "vertex %.9g %.9g %.9g\n", x, y, z));
        return vertices.size() - 1;
    }

    private void quad(double[] a, double[] b, double[] c, double[] d) {
        int first = vertex(a[0], a[1], a[2]);
        vertex(b[0], b[1], b[2]);
        vertex(c[0], c[1], c[2]);
        vertex(d[0], d[1], d[2]);
        triangles.add("tri " + first + " " + (first + 1) + " " + (first + 2) + "\n");
        triangles.add("tri " + first + " " + (first + 2) + " " + (first + 3) + "\n");
    }

    private String mesh() {
        return "maxverts " + vertices.size() + "\n" + String.join("", vertices) + String.join("", triangles);
    }

    private String needles() {
        for (int k = 0; k < 60; k++) {
            double angle = between(0, Math.PI), x = between(-4, 4), y = between(-3, 3), length = between(1, 4);
            double half = between(.003, .02), dx = Math.cos(angle), dy = Math.sin(angle);
            int a = vertex(x - dy * half, y + dx * half, 0), b = vertex(x + dy * half, y - dx * half, 0);
            triangles.add("tri " + a + " " + b + " " + vertex(x + dx * length, y + dy * length, 0) + "\n");
        }
        return FRONT + "ambient .9 .8 .7\n" + mesh();
    }

    private String spheres(int count, double width, double min, double max) {
        StringBuilder out = new StringBuilder();
        for (int k = 0; k < count; k++) {
            out.append(String.format(Locale.ROOT, "sphere %.6f %.6f %.6f %.5f\n", between(-width, width), between(-3, 3),
                    between(-2, 2), between(min, max)));
        }
        return out.toString();
    }

    private String fence() {
        for (int k = 0; k < 110; k++) {
            double x = -4.2 + .0767 * k;
            quad(new double[] {x, -3, 0}, new double[] {x + .02, -3, 0}, new double[] {x + .32, 3, 0}, new double[] {x + .3, 3, 0});
        }
        return FRONT + "ambient .9 .9 .9\n" + mesh();
    }

    private String horizon() {
        for (int k = 0; k < 60; k++) {
            double z = 4 - 1.5 * k;
            quad(new double[] {-30, 0, z}, new double[] {30, 0, z}, new double[] {30, 0, z - .4}, new double[] {-30, 0, z - .4});
        }
        return SIZE + "camera 0 1 6 0 .6 0 0 1 0 45\ndirectional .3 1 .5 .8 .8 .8\nambient .1 .1 .1\ndiffuse .7 .7 .7\n" + mesh();
    }

    private String shadows() {
        for (int k = 0; k < 40; k++) {
            double x = -3 + .15 * k;
            quad(new double[] {x, 2, 0}, new double[] {x + .01, 2, 0}, new double[] {x + .01, 2, 2}, new double[] {x, 2, 2});
        }
        return SIZE + "camera 0 3 7 0 0 0 0 1 0 45\npoint 1 6 2 .9 .9 .9\nambient .05 .05 .05\ndiffuse .8 .8 .7\n"
                + "plane 0 0 0 0 1 0\n" + mesh();
    }

    private static String highlights() {
        StringBuilder out = new StringBuilder(FRONT + "point 3 5 8 1 1 1\npoint -4 2 9 .6 .6 .6\ndiffuse .1 .1 .2\n"
                + "specular 1 1 1\nshininess 200000\n");
        for (int k = 0; k < 48; k++) {
            out.append("sphere ").append(k % 8 - 3.5).append(' ').append(k / 8 - 2.5).append(" 0 .45\n");
        }
        return out.toString();
    }

    private static String junctions() {
        return FRONT + "directional .2 .3 1 .8 .8 .8\nambient .1 .1 .1\ndiffuse .7 .3 .2\nmaxverts 6\nvertex -3 -2 0\nvertex 3 -2 0\n"
                + "vertex 3 2 0\nvertex -3 2 0\nvertex 0 .013 0\nvertex 1.1 .013 0\ntri 0 1 4\ntri 1 2 5\ntri 4 1 5\ntri 2 3 4\n"
                + "tri 2 4 5\ntri 3 0 4\n";
    }

    private String farMesh() {
        int n = 60;
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
                vertex(.4 * x, .4 * y, .1 * Math.sin(9 * x) * Math.cos(7 * y));
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int a = i * (n + 1) + j, b = a + n + 1;
                triangles.add("tri " + a + " " + b + " " + (a + 1) + "\ntri " + (a + 1) + " " + b + " " + (b + 1) + "\n");
            }
        }
        return FRONT + "directional .5 .4 1 .9 .9 .9\nambient .05 .05 .05\ndiffuse .7 .6 .5\n" + mesh();
    }
}
