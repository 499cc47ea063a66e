package raytracer.stability;

import java.util.Random;

/** Random small scenes, each family made of what some method fails at. The same seed gives the same scene. */
enum Families {

    /** Shapes of all kinds, anywhere. */
    ORDINARY {
        @Override
        void shapes(Writer w) {
            w.line("plane", 0, -1.5, 0, w.gauss(.1), 1, w.gauss(.1));
            for (int i = 0; i < 6; i++) {
                w.material();
                w.line("sphere", w.within(2), w.within(1.5), w.within(2), .2 + w.unit() * .8);
                w.material();
                w.triangle(w.point(2), w.point(2), w.point(2));
            }
        }
    },

    /** Whole numbers and halves only, seen from an axis: distances tie exactly, rays meet edges and seams exactly. */
    LATTICE {
        @Override
        void shapes(Writer w) {
            w.line("plane", 0, -2, 0, 0, 1, 0);
            for (int i = 0; i < 6; i++) {
                w.material();
                w.line("sphere", w.whole(2), w.whole(2), w.whole(2), .5 + .5 * w.random.nextInt(2));
                w.material();
                w.triangle(new double[] {w.whole(2), w.whole(2), w.whole(2)},
                        new double[] {w.whole(2), w.whole(2), w.whole(2)},
                        new double[] {w.whole(2), w.whole(2), w.whole(2)});
            }
        }
    },

    /** Every shape twice or more, in other words: turned triangles, planes through triangles, equal spheres. */
    DUPLICATES {
        @Override
        void shapes(Writer w) {
            w.line("plane", 0, -1, 0, 0, 1, 0);
            for (int i = 0; i < 3; i++) {
                double[] a = w.point(2), b = w.point(2), c = w.point(2);
                a[1] = b[1] = c[1] = i == 0 ? -1 : .25 * i;
                for (double[][] t : new double[][][] {{a, b, c}, {c, b, a}, {b, c, a}}) {
                    w.material();
                    w.triangle(t[0], t[1], t[2]);
                }
                w.material();
                double x = w.within(2), y = w.within(1), z = w.within(2), r = .3 + w.unit() / 2;
                w.line("sphere", x, y, z, r);
                w.material();
                w.line("sphere", x, y, z, r);
                w.line("plane", w.within(9), -1, w.within(9), 0, 1 + w.unit(), 0);
            }
        }
    },

    /** Spheres that rest on a huge sphere, boxes that stand on one another: contacts. */
    CONTACTS {
        @Override
        void shapes(Writer w) {
            double radius = Math.scalb(1.0, 4 + w.random.nextInt(20));
            w.line("sphere", 0, -1 - radius, 0, radius);
            for (int i = 0; i < 4; i++) {
                w.material();
                double r = .25 * (1 + w.random.nextInt(3)), x = w.within(2), z = w.within(2);
                w.line("sphere", x, r - 1, z, r);
                w.material();
                w.box(x, -1, z, .5 * r, r);
                w.box(x, r - 1, z, .25, .5);
            }
        }
    },

    /** Mirrors that face one another, and deep paths between them. */
    MIRRORS {
        @Override
        void shapes(Writer w) {
            w.text("specular .8 .7 .9");
            w.line("plane", 3, 0, 0, -1, w.gauss(.02), 0);
            w.line("plane", -3, 0, 0, 1, 0, w.gauss(.02));
            w.line("plane", 0, -2, 0, 0, 1, 0);
            for (int i = 0; i < 3; i++) {
                w.material();
                w.line("sphere", w.within(2), w.within(1.5), w.within(2), .2 + w.unit() / 2);
            }
            w.triangle(w.point(2), w.point(2), w.point(2));
        }

        @Override
        int depth(Random random) {
            return 2 + random.nextInt(9);
        }
    },

    /** Needles and fans: triangles a million times as long as wide, many at one corner. */
    NEEDLES {
        @Override
        void shapes(Writer w) {
            // Turned, so that no edge is parallel to a light: decimals would leave that open.
            double turn = w.unit();
            double[] hub = w.point(.5);
            for (int i = 0; i < 12; i++) {
                double a = turn + Math.PI * i / 6, b = turn + Math.PI * (i + 1) / 6;
                w.material();
                w.triangle(hub, new double[] {2 * Math.cos(a), 2 * Math.sin(a), .3},
                        new double[] {2 * Math.cos(b), 2 * Math.sin(b), .3});
            }
            for (int i = 0; i < 6; i++) {
                double[] tip = w.point(2), far = w.point(2);
                w.triangle(tip, far, new double[] {far[0] + w.gauss(1e-6), far[1] + w.gauss(1e-6), far[2]});
            }
        }
    },

    /** The camera within spheres, some of them within others; a light there too. */
    INSIDE {
        @Override
        void shapes(Writer w) {
            w.line("sphere", 0, 0, 0, 9);
            w.material();
            w.line("sphere", w.gauss(.1), w.gauss(.1), 5, 2 + w.unit());
            for (int i = 0; i < 5; i++) {
                w.material();
                w.line("sphere", w.within(4), w.within(3), w.within(4), .3 + w.unit());
            }
        }

        @Override
        int depth(Random random) {
            return 1 + random.nextInt(4);
        }
    };

    abstract void shapes(Writer w);

    int depth(Random random) {
        return 1 + random.nextInt(3);
    }

    /** A scene of this family; lengths are multiplied by a factor and then everything is moved along each axis. */
    String scene(long seed, int width, int height, double scale, double offset) {
        Writer w = new Writer(new Random(31 * seed + ordinal()), scale, offset);
        boolean axis = this == LATTICE;
        w.text("size " + width + " " + height);
        w.text("maxdepth " + depth(w.random));
        w.text("maxverts 1000");
        w.move("camera", axis ? new double[] {0, 0, 4} : new double[] {w.within(1), w.within(1), 6});
        w.add(axis ? new double[] {0, 0, 0} : w.point(.5)).end(" 0 1 0 " + (axis ? 90 : 30 + 40 * w.unit()));
        int lights = 1 + w.random.nextInt(3);
        for (int i = 0; i < lights; i++) {
            if (w.random.nextInt(3) == 0) {
                w.text("directional " + w.whole(3) + " 2 " + w.whole(3) + " .4 .35 .3");
            } else {
                w.move("point", axis ? new double[] {w.whole(4), 4, 4} : new double[] {w.within(4), 2 + w.unit(), 4});
                w.end(" .5 .45 .4");
            }
        }
        w.material();
        shapes(w);
        return w.toString();
    }

    /** Writes commands, with every point scaled and moved. */
    static final class Writer {
        final Random random;
        private final double scale;
        private final double offset;
        private final StringBuilder text = new StringBuilder();
        private int vertices;

        Writer(Random random, double scale, double offset) {
            this.random = random;
            this.scale = scale;
            this.offset = offset;
        }

        @Override
        public String toString() {
            return text.toString();
        }

        double unit() {
            return random.nextDouble();
        }

        double within(double half) {
            return half * (2 * random.nextDouble() - 1);
        }

        double gauss(double sigma) {
            return sigma * random.nextGaussian();
        }

        double whole(int most) {
            return random.nextInt(2 * most + 1) - most;
        }

        double[] point(double half) {
            return new double[] {within(half), within(half), within(half)};
        }

        void text(String line) {
            text.append(line).append('\n');
        }

        void material() {
            // Random digits: colours that are sums of short decimals come to lie on the limit between two bytes.
            text("ambient " + .1 * unit() + " " + .1 * unit() + " " + .1 * unit());
            text("diffuse " + unit() + " " + unit() + " " + unit());
            int mirror = random.nextInt(3);
            text(mirror == 0 ? "specular 0 0 0" : "specular .2 .25 .3");
            text("shininess " + (1 << random.nextInt(8)));
        }

        /** Starts a command with a point. */
        Writer move(String keyword, double[] p) {
            text.append(keyword);
            return add(p);
        }

        Writer add(double[] p) {
            for (double c : p) {
                text.append(' ').append(c * scale + offset);
            }
            return this;
        }

        void end(String rest) {
            text.append(rest).append('\n');
        }

        /** A sphere or plane: a point, and a radius or normal. */
        void line(String keyword, double x, double y, double z, double... rest) {
            move(keyword, new double[] {x, y, z});
            for (double r : rest) {
                text.append(' ').append(rest.length == 1 ? r * scale : r);
            }
            end("");
        }

        void triangle(double[] a, double[] b, double[] c) {
            move("vertex", a).end("");
            move("vertex", b).end("");
            move("vertex", c).end("");
            text("tri " + vertices + " " + (vertices + 1) + " " + (vertices + 2));
            vertices += 3;
        }

        /** A box that stands on a height: twelve triangles that share no vertex numbers. */
        void box(double x, double y, double z, double half, double height) {
            double[][] c = new double[8][];
            for (int i = 0; i < 8; i++) {
                c[i] = new double[] {x + ((i & 1) == 0 ? -half : half), y + ((i & 2) == 0 ? 0 : height),
                    z + ((i & 4) == 0 ? -half : half)};
            }
            int[][] faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
            for (int[] f : faces) {
                triangle(c[f[0]], c[f[1]], c[f[2]]);
                triangle(c[f[0]], c[f[2]], c[f[3]]);
            }
        }
    }
}
