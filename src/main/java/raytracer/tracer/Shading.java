package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;

/** The light that surfaces of one material send back along a group of rays: Lambert and Blinn-Phong. */
final class Shading {

    /** The greatest whole exponent that is multiplied out. */
    private static final int MOST_MULTIPLIED = 1024;

    private final List<Surfaces> surfaces;
    private final List<Lamp> lamps;
    private final ShadowRays shadows = new ShadowRays();
    private long shadowCount;

    // By ray: the result.
    final double[] red = new double[Rays.CAPACITY];
    final double[] green = new double[Rays.CAPACITY];
    final double[] blue = new double[Rays.CAPACITY];

    Shading(List<Surfaces> surfaces, List<Lamp> lamps) {
        this.surfaces = surfaces;
        this.lamps = lamps;
    }

    /** How many shadow rays were traced since this was made. */
    long shadowCount() {
        return shadowCount;
    }

    /**
     * Shades rays from one index to another, which have arrived at surfaces of this material.
     *
     * @param samples if they have paths, these take note of which lights are seen
     */
    void shade(Rays rays, int from, int to, Material material, Samples samples, Scratch scratch) {
        Arrays.fill(red, from, to, material.ambient().red());
        Arrays.fill(green, from, to, material.ambient().green());
        Arrays.fill(blue, from, to, material.ambient().blue());
        if (material.diffuse().isBlack() && material.specular().isBlack()) {
            return;
        }
        for (Lamp lamp : lamps) {
            shadows.aim(rays, lamp, from, to);
            reflectance(rays, material, from, to, scratch);
            int open = open(material, from, to);
            if (open > 0) {
                shadowCount += open;
                for (Surfaces kind : surfaces) {
                    kind.block(rays, shadows, from, to, scratch);
                }
                addLight(lamp.colour(), material, from, to, scratch);
            }
            // Even where all are dark: a path must not depend on what other rays are in the group.
            if (samples.path != null) {
                extendPaths(samples, rays, from, to);
            }
        }
    }

    private void extendPaths(Samples samples, Rays rays, int from, int to) {
        for (int i = from; i < to; i++) {
            int p = rays.pixel[i];
            if (!rays.isFainter(i, samples.faintest)) {
                samples.path[p] = extendPath(samples.path[p], shadows.open[i] ? 1 : 0);
            }
        }
    }

    /** One more step of a path's number: different ones stay different but for chance. */
    static int extendPath(int path, int step) {
        return (path ^ step + 1) * 0x9E3779B1;
    }

    /** Computes the cosines that decide how much light the surface returns. */
    private void reflectance(Rays rays, Material material, int from, int to, Scratch scratch) {
        ShadowRays s = shadows;
        Passes.dot(rays.nx, rays.ny, rays.nz, s.dx, s.dy, s.dz, s.lambert, from, to);
        if (material.specular().isBlack()) {
            return;
        }
        // The half vector, not of length 1: the cosine is divided by its length instead.
        double[] hx = scratch.centreX, hy = scratch.centreY, hz = scratch.centreZ, length = scratch.square;
        Passes.subtract(s.dx, rays.dx, hx, from, to);
        Passes.subtract(s.dy, rays.dy, hy, from, to);
        Passes.subtract(s.dz, rays.dz, hz, from, to);
        Passes.length(hx, hy, hz, length, from, to);
        Passes.dot(rays.nx, rays.ny, rays.nz, hx, hy, hz, s.highlight, from, to);
        Passes.divide(s.highlight, length, from, to);
    }

    /** Opens the ways to the light on which it would add something; returns how many. */
    private int open(Material material, int from, int to) {
        boolean diffuse = !material.diffuse().isBlack(), specular = !material.specular().isBlack();
        boolean alwaysSpecular = specular && material.shininess() <= 0;
        int count = 0;
        for (int i = from; i < to; i++) {
            boolean open = shadows.distance[i] > 0 && (diffuse && shadows.lambert[i] > 0
                    || alwaysSpecular || specular && shadows.highlight[i] > 0);
            shadows.open[i] = open;
            count += open ? 1 : 0;
        }
        return count;
    }

    private void addLight(Colour light, Material material, int from, int to, Scratch scratch) {
        Colour diffuse = material.diffuse(), specular = material.specular();
        double[] most = scratch.square;
        most(shadows.open, most, from, to);
        Passes.cut(shadows.lambert, from, to);
        Passes.limit(shadows.lambert, most, from, to);
        addTerm(light, diffuse, shadows.lambert, from, to);
        if (!specular.isBlack()) {
            double[] power = scratch.along;
            Passes.cut(shadows.highlight, from, to);
            power(material.shininess(), shadows.highlight, power, from, to);
            Passes.limit(power, most, from, to);
            addTerm(light, specular, power, from, to);
        }
    }

    /** The most that can be returned: nothing where the light is not seen. */
    private static void most(boolean[] open, double[] most, int from, int to) {
        for (int i = from; i < to; i++) {
            most[i] = open[i] ? Double.POSITIVE_INFINITY : 0;
        }
    }

    /** Adds light times colour times a number by ray; nothing of something infinite is nothing. */
    private void addTerm(Colour light, Colour colour, double[] by, int from, int to) {
        if (light.red() != 0 && colour.red() != 0) {
            Passes.addScaled(red, light.red(), colour.red(), by, from, to);
        }
        if (light.green() != 0 && colour.green() != 0) {
            Passes.addScaled(green, light.green(), colour.green(), by, from, to);
        }
        if (light.blue() != 0 && colour.blue() != 0) {
            Passes.addScaled(blue, light.blue(), colour.blue(), by, from, to);
        }
    }

    /**
     * The highlights to the power of s. Whole exponents are multiplied out: that rounds by at most 2u s, no more than
     * what an error of the highlight by 2u grows to.
     *
     * @param factor the highlights, of [0, 1]; is overwritten
     */
    private static void power(double s, double[] factor, double[] power, int from, int to) {
        int n = (int) Math.abs(s);
        if (n != Math.abs(s) || n > MOST_MULTIPLIED) {
            for (int i = from; i < to; i++) {
                power[i] = Math.pow(factor[i], s);
            }
            return;
        }
        Arrays.fill(power, from, to, 1);
        for (; n > 0; n >>= 1) {
            if ((n & 1) == 1) {
                Passes.multiply(power, factor, from, to);
            }
            Passes.multiply(factor, factor, from, to);
        }
        if (s < 0) {
            Passes.invert(power, from, to);
        }
    }
}
