package raytracer.speed;

import java.util.Locale;

/** Scenes for measuring speed, each written out anew from a few formulas. */
final class SpeedScenes {

    private static final int SUNFLOWER = 4000;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private final StringBuilder out = new StringBuilder();

    private SpeedScenes() { }

    /** Spheres of every size as seeds of a sunflower over a huge ball for a floor, one light; no mirrors. */
    static String seeds() {
        SpeedScenes s = new SpeedScenes();
        s.line("size 1280 720\ncamera 0 -26 30 0 0 0 0 0 1 40\npoint -10 -10 25 .9 .9 .9\nambient .05 .05 .05");
        s.line("diffuse .6 .6 .55\nsphere 0 0 -10000 10000\nspecular .2 .2 .2\nshininess 60");
        for (int i = 1; i <= SUNFLOWER; i++) {
            double r = .2 * Math.sqrt(i), a = i * GOLDEN_ANGLE, size = .02 + .1 * (i % 7) / 6;
            if (i % 100 == 1) {
                s.line("diffuse %.2f .5 %.2f", .9 - .7 * i / SUNFLOWER, .1 + .7 * i / SUNFLOWER);
            }
            s.line("sphere %.6f %.6f %.6f %.6f", r * Math.cos(a), r * Math.sin(a), size, size);
        }
        return s.out.toString();
    }

    /** Mirroring balls in a cubic lattice, two lights. */
    static String lattice() {
        SpeedScenes s = new SpeedScenes();
        s.line("size 800 600\nmaxdepth 6\ncamera 7 5 9 .5 0 0 0 1 0 40\npoint 9 9 9 .5 .5 .5\ndirectional -1 2 1 .4 .4 .4");
        s.line("ambient .02 .02 .03\ndiffuse .3 .35 .5\nspecular .5 .5 .4\nshininess 80");
        for (int i = 0; i < 12 * 12 * 12; i++) {
            s.line("sphere %.4f %.4f %.4f %.4f", i % 12 * .5 - 2.75, i / 12 % 12 * .5 - 2.75, i / 144 * .5 - 2.75, .19);
        }
        return s.out.toString();
    }

    /** A mountain range of 2 n^2 triangles, one directional light; no mirrors. */
    static String mountains(int n) {
        SpeedScenes s = new SpeedScenes();
        s.line("size 640 480\ncamera 0 1.1 2 0 -.1 0 0 1 0 42\ndirectional .5 .5 .3 .9 .85 .8\nambient .05 .05 .08");
        s.line("diffuse .55 .5 .4\nmaxverts %d", (n + 1) * (n + 1));
        for (int j = 0; j <= n; j++) {
            for (int i = 0; i <= n; i++) {
                double x = 2.0 * i / n - 1, z = 2.0 * j / n - 1;
                double y = .2 * Math.sin(3 * x + 2 * z) * Math.cos(4 * z - x) + .06 * Math.sin(13 * x) * Math.sin(11 * z + 5 * x)
                        + .012 * Math.cos(47 * x + 31 * z) + .004 * Math.sin(150 * x) * Math.cos(140 * z);
                s.line("vertex %.6f %.6f %.6f", x, y, z);
            }
        }
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                int a = j * (n + 1) + i, b = a + n + 1;
                s.line("tri %d %d %d\ntri %d %d %d", a, b, a + 1, a + 1, b, b + 1);
            }
        }
        return s.out.toString();
    }

    /** A knotted tube of 2 n m triangles that mirrors, over a mirroring plane, two lights. */
    static String knot() {
        int n = 900, m = 48;
        SpeedScenes s = new SpeedScenes();
        s.line("size 640 480\nmaxdepth 5\ncamera 2 3 5 0 0 0 0 1 0 42\npoint 4 5 4 .6 .6 .6\npoint -4 6 1 .4 .4 .4");
        s.line("diffuse .2 .22 .25\nspecular .4 .4 .4\nshininess 40\nplane 0 -1.5 0 0 1 0");
        s.line("diffuse .5 .3 .1\nmaxverts %d", n * m);
        for (int i = 0; i < n; i++) {
            double t = 2 * Math.PI * i / n;
            for (int j = 0; j < m; j++) {
                double q = 2 * Math.PI * j / m + 3 * t, r = 1 + .4 * Math.cos(3 * t) + .22 * Math.cos(q);
                s.line("vertex %.6f %.6f %.6f", r * Math.cos(2 * t), .5 * Math.sin(3 * t) + .22 * Math.sin(q), r * Math.sin(2 * t));
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < m; j++) {
                int a = i * m + j, b = i * m + (j + 1) % m, c = (i + 1) % n * m + j, d = (i + 1) % n * m + (j + 1) % m;
                s.line("tri %d %d %d\ntri %d %d %d", a, c, b, b, c, d);
            }
        }
        return s.out.toString();
    }

    /** Two facing mirrors with a ball between them, seen 200 times. */
    static String corridor() {
        SpeedScenes s = new SpeedScenes();
        s.line("size 640 480\nmaxdepth 200\ncamera .4 .1 1.2 -.3 0 -1 0 1 0 60\npoint 0 .7 .9 .9 .9 .9\nambient .01 .01 .01");
        s.line("diffuse .05 .05 .05\nspecular .97 .96 .93\nshininess 20\nplane 1 0 0 -1 0 0\nplane -1 0 0 1 0 0");
        s.line("diffuse .6 .5 .3\nspecular 0 0 0\nplane 0 -1 0 0 1 0\ndiffuse .5 .2 .2\nspecular .3 .3 .3\nsphere 0 -.5 -1 .45");
        return s.out.toString();
    }

    private void line(String format, Object... values) {
        out.append(values.length == 0 ? format : String.format(Locale.ROOT, format, values)).append('\n');
    }
}
