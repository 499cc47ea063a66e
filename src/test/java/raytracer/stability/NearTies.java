package raytracer.stability;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * Scenes of surfaces that only rounding sets apart, so that A may tie with B and B with C, but not A with C: sheets of
 * one tilted plane, 1e-15 to 2e-14 apart at the offset that they are moved to.
 */
public enum NearTies {

    PLANES {
        @Override
        void sheet(Frame frame, double height, List<String> out) {
            out.add("plane " + frame.at(0, 0, height) + " " + frame.direction(0, 0, 1));
        }
    },

    TRIANGLES {
        @Override
        void sheet(Frame frame, double height, List<String> out) {
            for (int i = 0; i < 60; i++) {
                double x = 4 * frame.random.nextDouble() - 2, y = 3 * frame.random.nextDouble() - 1.5;
                String corners = "";
                for (int corner = 0; corner < 3; corner++) {
                    corners += " " + frame.vertex(
                            x + frame.random.nextDouble() - .5, y + frame.random.nextDouble() - .5, height);
                }
                out.add("tri" + corners);
            }
        }
    },

    SPHERES {
        @Override
        void sheet(Frame frame, double height, List<String> out) {
            for (int i = 0; i < 48; i++) {
                out.add("sphere " + frame.at(i % 8 * .4 - 1.4, i / 8 * .4 - 1, height) + " " + (.15 + height));
            }
        }
    };

    private static final int SHEETS = 10;

    abstract void sheet(Frame frame, double height, List<String> out);

    /** A turned and moved system of coordinates, and what was declared in it. */
    static final class Frame {
        final Random random;
        private final double offset;
        private final double[][] axes = new double[3][];
        private final List<String> vertices = new ArrayList<>();

        Frame(Random random, double offset) {
            this.random = random;
            this.offset = offset;
            double[] a = gauss(), b = gauss();
            axes[2] = unit(a);
            axes[0] = unit(cross(b, axes[2]));
            axes[1] = cross(axes[2], axes[0]);
        }

        private double[] gauss() {
            return new double[] {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
        }

        private static double[] unit(double[] v) {
            double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            return new double[] {v[0] / length, v[1] / length, v[2] / length};
        }

        private static double[] cross(double[] a, double[] b) {
            return new double[] {
                a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        }

        private String text(double base, double x, double y, double z) {
            StringBuilder text = new StringBuilder();
            for (int i = 0; i < 3; i++) {
                text.append(i > 0 ? " " : "").append(base + x * axes[0][i] + y * axes[1][i] + z * axes[2][i]);
            }
            return text.toString();
        }

        String at(double x, double y, double z) {
            return text(offset, x, y, z);
        }

        String direction(double x, double y, double z) {
            return text(0, x, y, z);
        }

        /** Declares a vertex; returns its number. */
        int vertex(double x, double y, double z) {
            vertices.add("vertex " + at(x, y, z));
            return vertices.size() - 1;
        }
    }

    /** The same seed gives the same scene. */
    public String scene(int seed, double offset, int width, int height) {
        Random random = new Random(seed);
        Frame frame = new Frame(random, offset);
        List<String> sheets = new ArrayList<>();
        double apart = Math.max(1, offset) * (1e-15 + random.nextDouble() * 1.9e-14) / SHEETS;
        for (int i = 0; i < SHEETS; i++) {
            sheet(frame, i * apart, sheets);
        }
        Collections.shuffle(sheets, random);
        StringBuilder text = new StringBuilder("size " + width + " " + height + "\nmaxdepth 3\n");
        text.append("camera ").append(frame.at(.5, .3, 4)).append(' ').append(frame.at(0, 0, 0)).append(' ')
                .append(frame.direction(0, 1, 0)).append(" 45\n");
        text.append("point ").append(frame.at(2, 1, 3)).append(" .6 .5 .4\n");
        text.append("directional ").append(frame.direction(-1, 2, 3)).append(" .3 .3 .4\n");
        text.append("maxverts ").append(frame.vertices.size() + 1).append('\n');
        frame.vertices.forEach(vertex -> text.append(vertex).append('\n'));
        for (String sheet : sheets) {
            text.append(String.format(Locale.ROOT, "ambient %.2f %.2f %.2f%n",
                    random.nextDouble(), random.nextDouble(), random.nextDouble()));
            text.append("diffuse .4 .4 .4\nspecular .2 .3 .2\n").append(sheet).append('\n');
        }
        return text.toString();
    }
}
