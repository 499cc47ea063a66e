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
    },

    /** Rays that graze mirrors and floors by 1e-5 to 1e-11: what they hit is far off along them, and not across. */
    GRAZING {
        @Override
        void view(Writer w) {
            double slope = w.power(-11, -5), angle = w.unit() * 2 * Math.PI;
            w.move("camera", new double[] {0, 0, 0});
            w.add(new double[] {slope * Math.cos(angle), slope * Math.sin(angle), -1}).end(" 0 1 0 " + 30 * (1 + w.unit()));
            w.text("directional 0 1 " + -w.power(-6, 0) + " .5 .5 .5");
        }

        @Override
        void shapes(Writer w) {
            w.text("specular .5 .4 .3");
            w.line("plane", 1, 0, 0, -1, 0, 0);
            w.line("plane", -1, 0, 0, 1, 0, 0);
            w.material();
            w.line("plane", 0, -1, 0, 0, 1, 0);
            w.material();
            w.line("plane", 0, 1 + w.random.nextInt(3), 0, 0, -1, 0);
            w.line("sphere", 0, 0, -5, .25);
        }

        @Override
        int depth(Random random) {
            return 2 + random.nextInt(4);
        }

        @Override
        boolean isMovable() {
            return false;
        }
    },

    /** A sphere 1e4 to 1e13 times as large as what stands on it, seen from close by. */
    HUGE_SPHERE {
        @Override
        void shapes(Writer w) {
            double radius = w.power(4, 13);
            w.line("sphere", 0, -1 - radius, 0, radius);
            for (int i = 0; i < 4; i++) {
                w.material();
                double r = .25 * (1 + w.random.nextInt(3));
                w.line("sphere", w.within(2), r - 1, w.within(2), r);
            }
            w.triangle(new double[] {-1, -1, 0}, new double[] {1, -1, .5}, new double[] {0, 1, .25});
        }

        @Override
        boolean isMovable() {
            return false;
        }
    },

    /** Planes through points 1e3 to 1e15 away, and triangles as large. */
    FAR_POINTS {
        @Override
        void shapes(Writer w) {
            double far = w.power(3, 15);
            w.line("plane", w.whole(1) * far, -1, far, 0, 1, 0);
            w.material();
            w.line("plane", far, w.whole(1) * far, -4, 0, 0, 1);
            for (int i = 0; i < 4; i++) {
                w.material();
                w.line("sphere", w.within(2), w.within(1), w.within(2), .2 + w.unit() / 2);
            }
            double wide = w.power(3, 9);
            w.triangle(new double[] {-wide, -1, -2}, new double[] {wide, -1, -2}, new double[] {0, wide, -3});
        }

        @Override
        boolean isMovable() {
            return false;
        }
    },

    /** A light on a sphere, at a corner, on an edge, on a plane: whatever touches it there is not in its way. */
    LIGHT_ON_SURFACES {
        @Override
        void view(Writer w) {
            super.view(w);
            w.move("point", new double[] {0, 1, 0}).end(" .5 .45 .4");
        }

        @Override
        void shapes(Writer w) {
            w.line("plane", 0, -1, 0, 0, 1, 0);
            double[][] spheres = {{0, 1.5, 0, .5}, {1, 1, 0, 1}, {0, .5, 0, .5}, {0, 1, -1, 1}};
            double[][][] triangles = {{{0, 1, 0}, {1, 2, -1}, {-1, 2, -1}}, {{-1, 1, -1}, {0, 1, 1}, {1, 1, -1}},
                {{-1, 0, 0}, {1, 2, 0}, {1, 2, 1}}};
            for (int i = 0; i < 2; i++) {
                w.material();
                double[] s = spheres[w.random.nextInt(spheres.length)];
                w.line("sphere", s[0], s[1], s[2], s[3]);
                w.material();
                double[][] t = triangles[w.random.nextInt(triangles.length)];
                w.triangle(t[0], t[1], t[2]);
            }
            w.material();
            w.line("plane", 0, 1, 0, 0, 1, 0);
        }

        @Override
        boolean isMovable() {
            return false;
        }
    },

    /** Things of 1e-8 to 1e-2 on a globe among things of 1e3 to 1e7. */
    MIXED_SCALES {
        @Override
        void shapes(Writer w) {
            double small = w.power(-8, -2), large = w.power(3, 7);
            w.line("sphere", 0, -1 - large, 0, large);
            for (int i = 0; i < 3; i++) {
                w.material();
                w.line("sphere", small * w.within(2), small - 1, small * w.within(2), small * (.2 + w.unit()));
                w.box(small * w.within(2), -1, small * w.within(2), small, small);
                w.material();
                w.box(large * w.within(2), -1, -large * (3 + i), large, large);
            }
            w.triangle(new double[] {-large, -1, -50}, new double[] {large, -1, -50}, new double[] {0, large, -60});
        }

        @Override
        boolean isMovable() {
            return false;
        }
    },

    /** A sheet over a floor, 1e-4 to 1e-11 apart, and a ball on it. */
    SHEETS {
        @Override
        void shapes(Writer w) {
            double gap = w.power(-11, -4);
            w.line("plane", 0, 0, 0, 0, 1, 0);
            w.material();
            double[] a = {-1, gap, -1}, b = {-1, gap, 1}, c = {1, gap, 1}, d = {1, gap, -1};
            w.triangle(a, b, c);
            w.material();
            w.triangle(a, c, d);
            w.line("sphere", 0, .5 + 2 * gap, 0, .5);
            w.material();
            w.line("plane", 0, -gap, 0, 0, 1, 0);
        }

        @Override
        boolean isMovable() {
            return false;
        }
    };

    abstract void shapes(Writer w);

    /** Whether doubles can tell its surfaces apart a million times its size from the origin. */
    boolean isMovable() {
        return true;
    }

    int depth(Random random) {
        return 1 + random.nextInt(3);
    }

    /** A scene of this family; lengths are multiplied by a factor and then everything is moved along each axis. */
    String scene(long seed, int width, int height, double scale, double offset) {
        Writer w = new Writer(new Random(31 * seed + ordinal()), scale, isMovable() ? offset : 0);
        w.text("size " + width + " " + height);
        w.text("maxdepth " + depth(w.random));
        w.text("maxverts 1000");
        view(w);
        w.material();
        shapes(w);
        return w.toString();
    }

    /** The camera and lights. */
    void view(Writer w) {
        boolean axis = this == LATTICE;
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

        /** Of ten, between two exponents. */
        double power(double least, double most) {
            return Math.pow(10, least + (most - least) * random.nextDouble());
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
