package raytracer.stability;

import java.util.Random;

/**
 * Floors that the middle row of a picture grazes: the eye is hardly above, and looks at a point on them 6 away. Things on
 * and over them throw shadows there, some right beside one another.
 */
enum GrazedFloors {

    PLANE {
        @Override
        void floor(Families.Writer w, double radius) {
            w.line("plane", 0, 0, 0, 0, 1, 0);
        }
    },

    TRIANGLES {
        @Override
        void floor(Families.Writer w, double radius) {
            double[] a = {-21, 0, -20}, b = {20, 0, -20}, c = {20, 0, 20}, d = {-20, 0, 20};
            w.triangle(c, b, a);
            w.text("diffuse .1 .2 .3");
            w.triangle(d, c, a);
        }
    },

    /** Of a radius of 100 to 100,000: it bends down from where the eye is to where that looks. */
    SPHERE {
        @Override
        void floor(Families.Writer w, double radius) {
            w.line("sphere", 0, -radius, 0, radius);
        }

        @Override
        double level(double radius) {
            return -36 / (radius + Math.sqrt(radius * radius - 36));
        }
    };

    /** @param radius of a sphere that is a floor */
    abstract void floor(Families.Writer w, double radius);

    /** Of the floor under the eye. */
    double level(double radius) {
        return 0;
    }

    /**
     * @param height of the eye over the floor
     * @param depth  how many surfaces a path may meet: with more than one, all are mirrors
     */
    String scene(long seed, double height, int columns, int rows, int depth) {
        Families.Writer w = new Families.Writer(new Random(31 * seed + ordinal()), 1, 0);
        double radius = w.power(2, 5);
        double yaw = w.random.nextInt(3) == 0 ? 0 : w.within(1);
        w.text("size " + columns + " " + rows);
        w.move("camera", new double[] {6 * Math.sin(yaw), level(radius) + height, 6 * Math.cos(yaw)});
        w.end(" 0 0 0 0 1 0 " + (rows == 1 ? .1 * 1201 / columns : 5 + 35 * w.unit()));
        w.text("maxdepth " + depth);
        w.move("point", new double[] {w.within(4), 2 + 5 * w.unit(), w.within(3)}).end(" .6 .6 .6");
        w.text("directional " + w.within(1) + " 1 " + w.within(1) + " .3 .25 .2");
        w.text("diffuse .7 .71 .69\nambient .05 .06 .04\nspecular " + (depth > 1 ? ".3 .35 .4" : "0 0 0"));
        w.text("maxverts 200");
        floor(w, radius);
        for (int i = 0; i < 3; i++) {
            w.text("diffuse " + w.unit() + " " + w.unit() + " " + w.unit());
            thing(w, w.within(1.5), w.within(1.5));
        }
        return w.toString();
    }

    private static void thing(Families.Writer w, double x, double z) {
        switch (w.random.nextInt(4)) {
            case 0 -> w.box(x, 0, z, .1 + .4 * w.unit(), .05 + w.unit());
            case 1 -> w.box(w.whole(1), 0, -Math.abs(w.whole(2)), .5, .5);
            case 2 -> w.line("sphere", x, .6 + w.unit(), z, .1 + .5 * w.unit());
            default -> w.triangle(new double[] {x + w.within(.3), .1 + w.unit(), z + w.within(.3)},
                    new double[] {x + w.within(.3), .1 + w.unit(), z + w.within(.3)},
                    new double[] {x + w.within(.3), .1 + w.unit(), z + w.within(.3)});
        }
    }
}
