package raytracer.tracer;

import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Vectors;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.AnyHit;
import raytracer.tracer.search.SearchWorkspace;
import raytracer.tracer.settled.SettledCells;
import raytracer.tracer.surface.Surfaces;

/** The light that surfaces of one material send back along a group of rays: Lambert and Blinn-Phong. */
final class Shading {

    /** The greatest whole exponent that is multiplied out. */
    private static final int MAX_MULTIPLIED = 1024;

    private final List<LightSource> lights;
    private final Rays rays;
    private final ShadowRays shadows;
    private long shadowCount;

    // What is shaded, and from which light.
    private Material material;
    private LightSource light;

    private final Kernel aim = this::aim;
    private final Kernel findReflectance = this::findReflectance;
    private final Kernel addLight = this::addLight;
    private final Kernel[] block;

    private final Kernel findLambert;
    private final Kernel findHighlight;
    private final Kernel limitLambert;
    private final Kernel cutHighlight;
    private final Kernel multiplyPower;
    private final Kernel squareHighlight;
    private final Kernel invertPower;
    private final Kernel limitPower;

    // By ray: the light that is left, none or any; the highlight to the power of the shininess.
    private final double[] max = new double[Batch.CAPACITY];
    private final double[] power = new double[Batch.CAPACITY];

    // By ray: the result.
    final double[] red = new double[Batch.CAPACITY];
    final double[] green = new double[Batch.CAPACITY];
    final double[] blue = new double[Batch.CAPACITY];

    private final Term diffuseTerm;
    private final Term specularTerm;

    /** @param rays what is shaded, when it has arrived */
    Shading(List<Surfaces> surfaces, List<LightSource> lights, Rays rays, SearchWorkspace space) {
        this.lights = lights;
        this.rays = rays;
        shadows = new ShadowRays(rays);
        block = new Kernel[surfaces.size()];
        for (int kind = 0; kind < block.length; kind++) {
            block[kind] = AnyHit.among(surfaces.get(kind), rays, shadows, space);
        }
        ShadowRays s = shadows;
        findLambert = new Kernel.Dot(rays.normal, s.direction, s.lambert);
        // The half vector, not of length 1: the cosine is divided by its length instead.
        Vectors half = new Vectors();
        findHighlight = new Kernel.InTurn(
                Kernel.subtract(s.direction, rays.direction, half),
                new Kernel.Dot(rays.normal, half, s.highlight),
                new Kernel.Length(half, power),
                new Kernel.Divide(s.highlight, power, s.highlight));
        limitLambert = new Kernel.InTurn(new Kernel.Cut(s.lambert), new Kernel.Limit(s.lambert, max));
        cutHighlight = new Kernel.Cut(s.highlight);
        multiplyPower = new Kernel.Multiply(power, s.highlight);
        squareHighlight = new Kernel.Multiply(s.highlight, s.highlight);
        invertPower = new Kernel.Invert(power);
        limitPower = new Kernel.Limit(power, max);
        diffuseTerm = new Term(s.lambert);
        specularTerm = new Term(power);
    }

    /** Adds light times colour times a number by ray to the result. */
    private final class Term implements Kernel {
        private final double[] by;
        private Colour ofLight;
        private Colour ofSurface;

        Term(double[] by) {
            this.by = by;
        }

        void add(Colour light, Colour surface, int from, int to) {
            ofLight = light;
            ofSurface = surface;
            Kernel.run(this, from, to);
        }

        @Override
        public void run(int from, int to) {
            add(red, ofLight.red(), ofSurface.red(), from, to);
            add(green, ofLight.green(), ofSurface.green(), from, to);
            add(blue, ofLight.blue(), ofSurface.blue(), from, to);
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

    /** How far the last light is from where a ray has arrived. */
    double lightDistance(int ray) {
        return shadows.distance[ray];
    }

    /** Whether the last light is seen from there, if it would add anything. */
    boolean isUnoccluded(int ray) {
        return shadows.unoccluded[ray];
    }

    /** How many shadow rays were traced since this was made. */
    long shadowCount() {
        return shadowCount;
    }

    /**
     * Shades rays from one index to another, which have arrived at surfaces of this material.
     *
     * @param cells takes note of which lights are seen; null if nobody does
     */
    void shade(int from, int to, Material ofAll, SettledCells cells) {
        material = ofAll;
        Kernel.run(new Kernel.Fill(red, material.ambient().red()), from, to);
        Kernel.run(new Kernel.Fill(green, material.ambient().green()), from, to);
        Kernel.run(new Kernel.Fill(blue, material.ambient().blue()), from, to);
        if (material.diffuse().isBlack() && material.specular().isBlack()) {
            return;
        }
        shadows.start(from, to);
        for (LightSource each : lights) {
            light = each;
            Kernel.run(aim, from, to);
            Kernel.run(findReflectance, from, to);
            int unoccluded = markUnoccluded(from, to);
            if (cells != null) {
                cells.aimed(from, to, shadows);
            }
            if (unoccluded > 0) {
                shadowCount += unoccluded;
                for (Kernel kind : block) {
                    Kernel.run(kind, from, to);
                }
                Kernel.run(addLight, from, to);
            }
            if (cells != null) {
                cells.lit(from, to, shadows, material);
            }
        }
    }

    private void aim(int from, int to) {
        shadows.aim(light, from, to);
    }

    /** Computes the cosines that decide how much light the surface returns. */
    private void findReflectance(int from, int to) {
        Kernel.run(findLambert, from, to);
        if (!material.specular().isBlack()) {
            Kernel.run(findHighlight, from, to);
        }
    }

    /** Marks the shadow rays on which the light would add something; returns how many. */
    private int markUnoccluded(int from, int to) {
        boolean diffuse = !material.diffuse().isBlack(), specular = !material.specular().isBlack();
        boolean alwaysSpecular = specular && material.shininess() <= 0;
        int count = 0;
        for (int i = from; i < to; i++) {
            boolean unoccluded = shadows.distance[i] > 0 && (diffuse && shadows.lambert[i] > 0
                    || alwaysSpecular || specular && shadows.highlight[i] > 0);
            shadows.unoccluded[i] = unoccluded;
            count += unoccluded ? 1 : 0;
        }
        return count;
    }

    private void addLight(int from, int to) {
        max(shadows.unoccluded, max, from, to);
        Kernel.run(limitLambert, from, to);
        diffuseTerm.add(light.colour(), material.diffuse(), from, to);
        if (!material.specular().isBlack()) {
            Kernel.run(cutHighlight, from, to);
            power(material.shininess(), from, to);
            Kernel.run(limitPower, from, to);
            specularTerm.add(light.colour(), material.specular(), from, to);
        }
    }

    /** The most that can be returned: nothing where the light is not seen. */
    private static void max(boolean[] unoccluded, double[] max, int from, int to) {
        for (int i = from; i < to; i++) {
            max[i] = unoccluded[i] ? Double.POSITIVE_INFINITY : 0;
        }
    }

    /**
     * The highlights, which are overwritten, to the power of s. Whole exponents are multiplied out: that rounds by at
     * most 2u s, no more than what an error of the highlight by 2u grows to.
     */
    private void power(double s, int from, int to) {
        int n = (int) Math.abs(s);
        if (n != Math.abs(s) || n > MAX_MULTIPLIED) {
            for (int i = from; i < to; i++) {
                power[i] = Math.pow(shadows.highlight[i], s);
            }
            return;
        }
        Kernel.run(new Kernel.Fill(power, 1), from, to);
        for (; n > 0; n >>= 1) {
            if ((n & 1) == 1) {
                Kernel.run(multiplyPower, from, to);
            }
            Kernel.run(squareHighlight, from, to);
        }
        if (s < 0) {
            Kernel.run(invertPower, from, to);
        }
    }
}
