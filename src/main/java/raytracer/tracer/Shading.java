package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.AnyHit;
import raytracer.tracer.search.Search;
import raytracer.tracer.surface.Workspace;

/** The light that surfaces of one material send back along a group of rays: Lambert and Blinn-Phong. */
final class Shading {

    /** The greatest whole exponent that is multiplied out. */
    private static final int MAX_MULTIPLIED = 1024;

    private final List<LightSource> lights;
    private final Rays rays;
    final ShadowRays shadows;
    private long shadowCount;

    private final Search[] anyHit;

    // By ray: the result.
    final double[] red = new double[Batch.CAPACITY];
    final double[] green = new double[Batch.CAPACITY];
    final double[] blue = new double[Batch.CAPACITY];

    /** @param rays what is shaded, when it has arrived */
    Shading(Tracer tracer, List<LightSource> lights, Rays rays, Workspace workspace) {
        this.lights = lights;
        this.rays = rays;
        shadows = new ShadowRays(rays);
        anyHit = tracer.scene().shadow() ? tracer.surfaces().stream()
                .map(kind -> AnyHit.among(kind, rays, shadows, workspace)).toArray(Search[]::new) : new Search[0];
    }

    /** What came out of a ray's shading. */
    Colour colour(int ray) {
        return new Colour(red[ray], green[ray], blue[ray]);
    }

    /** How many shadow rays were needed since this was made: points that a light might reach. */
    long shadowCount() {
        return shadowCount;
    }

    /** Shades rays from one index to another, which have arrived at surfaces of this material. */
    void shade(int from, int to, Material material) {
        Arrays.fill(red, from, to, material.ambient().red());
        Arrays.fill(green, from, to, material.ambient().green());
        Arrays.fill(blue, from, to, material.ambient().blue());
        if (material.diffuse().isBlack() && material.specular().isBlack()) {
            return;
        }
        shadows.start(from, to);
        for (LightSource light : lights) {
            shadows.aim(light, from, to);
            int unoccluded = findReflectance(material, from, to);
            if (unoccluded > 0) {
                shadowCount += unoccluded;
                for (Search kind : anyHit) {
                    kind.run(from, to);
                }
                addLight(material, light.colour(), from, to);
            }
        }
    }

    /**
     * Computes the cosines that decide how much light the surface returns, and marks the shadow rays on which it would
     * return any; returns how many.
     */
    private int findReflectance(Material material, int from, int to) {
        boolean diffuse = !material.diffuse().isBlack(), specular = !material.specular().isBlack();
        boolean alwaysSpecular = specular && material.shininess() <= 0;
        int count = 0;
        for (int i = from; i < to; i++) {
            double nx = rays.nx[i], ny = rays.ny[i], nz = rays.nz[i];
            double lx = shadows.dx[i], ly = shadows.dy[i], lz = shadows.dz[i];
            double lambert = nx * lx + ny * ly + nz * lz;
            double highlight = 0;
            if (specular) {
                // The half vector, not of length 1: the cosine is divided by its length instead.
                double hx = lx - rays.dx[i], hy = ly - rays.dy[i], hz = lz - rays.dz[i];
                highlight = (nx * hx + ny * hy + nz * hz)
                        / Math.max(Math.sqrt(hx * hx + hy * hy + hz * hz), Double.MIN_NORMAL);
            }
            shadows.lambert[i] = lambert;
            shadows.highlight[i] = highlight;
            boolean adds = shadows.distance[i] > 0 && (diffuse && lambert > 0 || alwaysSpecular || highlight > 0);
            shadows.unoccluded[i] = adds;
            count += adds ? 1 : 0;
        }
        return count;
    }

    /** Adds what the surface returns of the light, to the rays whose shadow rays are unoccluded. */
    private void addLight(Material material, Colour ofLight, int from, int to) {
        Colour diffuse = material.diffuse(), specular = material.specular();
        boolean isShiny = !specular.isBlack();
        for (int i = from; i < to; i++) {
            if (shadows.unoccluded[i]) {
                double lambert = cut(shadows.lambert[i]);
                double highlight = isShiny ? power(cut(shadows.highlight[i]), material.shininess()) : 0;
                red[i] = plus(red[i], ofLight.red(), diffuse.red(), lambert, specular.red(), highlight);
                green[i] = plus(green[i], ofLight.green(), diffuse.green(), lambert, specular.green(), highlight);
                blue[i] = plus(blue[i], ofLight.blue(), diffuse.blue(), lambert, specular.blue(), highlight);
            }
        }
    }

    /** Adds the light to one component of a colour; an infinite highlight of a black component adds nothing. */
    private static double plus(
            double sum, double light, double diffuse, double lambert, double specular, double highlight) {
        double withDiffuse = sum + light * (diffuse * lambert);
        return light == 0 || specular == 0 ? withDiffuse : withDiffuse + light * (specular * highlight);
    }

    private static double cut(double cosine) {
        return Math.min(1, Math.max(0, cosine));
    }

    /**
     * A highlight to the power of s. Whole exponents are multiplied out: that rounds by at most 2u s, no more than what
     * an error of the highlight by 2u grows to.
     */
    private static double power(double highlight, double s) {
        int n = (int) Math.abs(s);
        if (n != Math.abs(s) || n > MAX_MULTIPLIED) {
            return Math.pow(highlight, s);
        }
        double power = 1;
        for (double square = highlight; n > 0; n >>= 1) {
            if ((n & 1) == 1) {
                power *= square;
            }
            square *= square;
        }
        return s < 0 ? 1 / power : power;
    }
}
