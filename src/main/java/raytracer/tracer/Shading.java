package raytracer.tracer;

import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.kernel.Pass;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.primitive.Surfaces;
import raytracer.tracer.rays.Lamp;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.BlockerSearch;
import raytracer.tracer.search.SearchWorkspace;

/** The light that surfaces of one material send back along a group of rays: Lambert and Blinn-Phong. */
final class Shading {

    /** The greatest whole exponent that is multiplied out. */
    private static final int MOST_MULTIPLIED = 1024;

    private final List<Lamp> lamps;
    private final Rays rays;
    private final ShadowRays shadows;
    private long shadowCount;

    // What is shaded, and from which lamp.
    private Material material;
    private Lamp lamp;

    private final Pass aim = this::aim;
    private final Pass findReflectance = this::findReflectance;
    private final Pass addLight = this::addLight;
    private final Pass[] block;

    private final Pass findLambert;
    private final Pass findHighlight;
    private final Pass limitLambert;
    private final Pass cutHighlight;
    private final Pass multiplyPower;
    private final Pass squareHighlight;
    private final Pass invertPower;
    private final Pass limitPower;

    // By ray: the light that is left, none or any; the highlight to the power of the shininess.
    private final double[] most = new double[Batch.CAPACITY];
    private final double[] power = new double[Batch.CAPACITY];

    // By ray: the result.
    final double[] red = new double[Batch.CAPACITY];
    final double[] green = new double[Batch.CAPACITY];
    final double[] blue = new double[Batch.CAPACITY];

    private final Term diffuseTerm;
    private final Term specularTerm;

    /** @param rays what is shaded, when it has arrived */
    Shading(List<Surfaces> surfaces, List<Lamp> lamps, Rays rays, SearchWorkspace space) {
        this.lamps = lamps;
        this.rays = rays;
        shadows = new ShadowRays(rays);
        block = new Pass[surfaces.size()];
        for (int kind = 0; kind < block.length; kind++) {
            block[kind] = BlockerSearch.among(surfaces.get(kind), rays, shadows, space);
        }
        ShadowRays s = shadows;
        findLambert = new Pass.Dot(rays.normal, s.direction, s.lambert);
        // The half vector, not of length 1: the cosine is divided by its length instead.
        Vectors half = new Vectors();
        findHighlight = new Pass.InTurn(
                Pass.subtract(s.direction, rays.direction, half),
                new Pass.Dot(rays.normal, half, s.highlight),
                new Pass.Length(half, power),
                new Pass.Divide(s.highlight, power, s.highlight));
        limitLambert = new Pass.InTurn(new Pass.Cut(s.lambert), new Pass.Limit(s.lambert, most));
        cutHighlight = new Pass.Cut(s.highlight);
        multiplyPower = new Pass.Multiply(power, s.highlight);
        squareHighlight = new Pass.Multiply(s.highlight, s.highlight);
        invertPower = new Pass.Invert(power);
        limitPower = new Pass.Limit(power, most);
        diffuseTerm = new Term(s.lambert);
        specularTerm = new Term(power);
    }

    /** Adds light times colour times a number by ray to the result. */
    private final class Term implements Pass {
        private final double[] by;
        private Colour light;
        private Colour colour;

        Term(double[] by) {
            this.by = by;
        }

        void add(Colour ofLight, Colour ofSurface, int from, int to) {
            light = ofLight;
            colour = ofSurface;
            Pass.run(this, from, to);
        }

        @Override
        public void run(int from, int to) {
            add(red, light.red(), colour.red(), from, to);
            add(green, light.green(), colour.green(), from, to);
            add(blue, light.blue(), colour.blue(), from, to);
        }

        /** Nothing of something infinite is nothing. */
        private void add(double[] out, double f, double g, int from, int to) {
            if (f != 0 && g != 0) {
                addScaled(out, f, g, by, from, to);
            }
        }
    }

    private static void addScaled(double[] out, double f, double g, double[] by, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] += f * (g * by[i]);
        }
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
    void shade(int from, int to, Material ofAll, Samples samples) {
        material = ofAll;
        Pass.run(new Pass.Fill(red, material.ambient().red()), from, to);
        Pass.run(new Pass.Fill(green, material.ambient().green()), from, to);
        Pass.run(new Pass.Fill(blue, material.ambient().blue()), from, to);
        if (material.diffuse().isBlack() && material.specular().isBlack()) {
            return;
        }
        shadows.start(from, to);
        for (Lamp each : lamps) {
            lamp = each;
            Pass.run(aim, from, to);
            Pass.run(findReflectance, from, to);
            int open = open(from, to);
            if (open > 0) {
                shadowCount += open;
                for (Pass kind : block) {
                    Pass.run(kind, from, to);
                }
                Pass.run(addLight, from, to);
            }
            // Even where all are dark: a path must not depend on what other rays are in the group.
            if (samples.path != null) {
                extendPaths(samples, from, to);
            }
        }
    }

    private void aim(int from, int to) {
        shadows.aim(lamp, from, to);
    }

    private void extendPaths(Samples samples, int from, int to) {
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
    private void findReflectance(int from, int to) {
        Pass.run(findLambert, from, to);
        if (!material.specular().isBlack()) {
            Pass.run(findHighlight, from, to);
        }
    }

    /** Opens the ways to the light on which it would add something; returns how many. */
    private int open(int from, int to) {
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

    private void addLight(int from, int to) {
        Colour light = lamp.colour();
        most(shadows.open, most, from, to);
        Pass.run(limitLambert, from, to);
        diffuseTerm.add(light, material.diffuse(), from, to);
        if (!material.specular().isBlack()) {
            Pass.run(cutHighlight, from, to);
            power(material.shininess(), from, to);
            Pass.run(limitPower, from, to);
            specularTerm.add(light, material.specular(), from, to);
        }
    }

    /** The most that can be returned: nothing where the light is not seen. */
    private static void most(boolean[] open, double[] most, int from, int to) {
        for (int i = from; i < to; i++) {
            most[i] = open[i] ? Double.POSITIVE_INFINITY : 0;
        }
    }

    /**
     * The highlights, which are overwritten, to the power of s. Whole exponents are multiplied out: that rounds by at
     * most 2u s, no more than what an error of the highlight by 2u grows to.
     */
    private void power(double s, int from, int to) {
        int n = (int) Math.abs(s);
        if (n != Math.abs(s) || n > MOST_MULTIPLIED) {
            for (int i = from; i < to; i++) {
                power[i] = Math.pow(shadows.highlight[i], s);
            }
            return;
        }
        Pass.run(new Pass.Fill(power, 1), from, to);
        for (; n > 0; n >>= 1) {
            if ((n & 1) == 1) {
                Pass.run(multiplyPower, from, to);
            }
            Pass.run(squareHighlight, from, to);
        }
        if (s < 0) {
            Pass.run(invertPower, from, to);
        }
    }
}
