package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Vectors;
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

    /** Below this times the least double nothing is seen. */
    private static final double BLINDING = 0x1p1000;

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
        rays.normal.dot(shadows.direction, shadows.lambert, from, to);
        boolean isShiny = !material.specular().isBlack();
        if (isShiny) {
            findHighlights(from, to);
        } else {
            Arrays.fill(shadows.highlight, from, to, 0);
        }
        return mark(!material.diffuse().isBlack(), isShiny && material.shininess() <= 0, from, to);
    }

    private int mark(boolean diffuse, boolean alwaysSpecular, int from, int to) {
        double[] lambert = shadows.lambert, highlight = shadows.highlight;
        int count = 0;
        for (int i = from; i < to; i++) {
            boolean adds = shadows.distance[i] > 0 && (diffuse && lambert[i] > 0 || alwaysSpecular || highlight[i] > 0);
            shadows.unoccluded[i] = adds;
            count += adds ? 1 : 0;
        }
        return count;
    }

    /** The cosines of the half vectors, which are not of length 1: the cosines are divided by their lengths instead. */
    private void findHighlights(int from, int to) {
        double[] dx = rays.dx, dy = rays.dy, dz = rays.dz, lx = shadows.dx, ly = shadows.dy, lz = shadows.dz;
        double[] nx = rays.nx, ny = rays.ny, nz = rays.nz, cosine = shadows.highlight, square = shadows.halfSquare;
        Arrays.fill(cosine, from, to, 0);
        Arrays.fill(square, from, to, 0);
        addHalf(lx, dx, nx, cosine, square, from, to);
        addHalf(ly, dy, ny, cosine, square, from, to);
        addHalf(lz, dz, nz, cosine, square, from, to);
        divideByRoot(square, cosine, from, to);
    }

    /** Of one axis: adds the half vector times the normal, and its square. */
    private static void addHalf(double[] l, double[] d, double[] n, double[] cosine, double[] square, int from, int to) {
        for (int i = from; i < to; i++) {
            double h = l[i] - d[i];
            cosine[i] += n[i] * h;
            square[i] += h * h;
        }
    }

    private static void divideByRoot(double[] square, double[] out, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] /= Math.max(Math.sqrt(square[i]), Double.MIN_NORMAL);
        }
    }

    /** A part of {@link #addLight}: three, called in one place, so that HotSpot inlines none and compiles each alone. */
    private interface Step {

        void run(Shading shading, Material material, Colour light, int from, int to);
    }

    private static final List<Step> STEPS = List.of(Shading::finishCosines, Shading::darken, Shading::add);

    /** Adds what the surface returns of the light, to the rays whose shadow rays are unoccluded. */
    private void addLight(Material material, Colour light, int from, int to) {
        for (int step = 0; step < 3; step++) {
            STEPS.get(step).run(this, material, light, from, to);
        }
    }

    private void finishCosines(Material material, Colour light, int from, int to) {
        cut(shadows.lambert, from, to);
        if (!material.specular().isBlack()) {
            cut(shadows.highlight, from, to);
            raise(shadows.highlight, isBlinding(light) ? material.shininess() / 2 : material.shininess(), from, to);
        }
    }

    /** Whether a light is so bright that a highlight may be seen which no double holds; its root then is what is raised. */
    private static boolean isBlinding(Colour light) {
        return Math.max(light.red(), Math.max(light.green(), light.blue())) > BLINDING;
    }

    private void darken(Material material, Colour light, int from, int to) {
        double[] lambert = shadows.lambert, highlight = shadows.highlight;
        for (int i = from; i < to; i++) {
            if (!shadows.unoccluded[i]) {
                lambert[i] = 0;
                highlight[i] = 0;
            }
        }
    }

    private void add(Material material, Colour light, int from, int to) {
        Colour diffuse = material.diffuse(), specular = material.specular();
        boolean isRoot = isBlinding(light);
        add(red, light.red(), diffuse.red(), specular.red(), isRoot, from, to);
        add(green, light.green(), diffuse.green(), specular.green(), isRoot, from, to);
        add(blue, light.blue(), diffuse.blue(), specular.blue(), isRoot, from, to);
    }

    private static void cut(double[] cosine, int from, int to) {
        for (int i = from; i < to; i++) {
            cosine[i] = Math.min(1, Math.max(0, cosine[i]));
        }
    }

    /** Adds the light to one component of colours; an infinite highlight of a black component adds nothing. */
    private void add(double[] sum, double light, double diffuse, double specular, boolean isRoot, int from, int to) {
        double[] lambert = shadows.lambert, highlight = shadows.highlight;
        if (light == 0 || specular == 0) {
            for (int i = from; i < to; i++) {
                sum[i] += light * (diffuse * lambert[i]);
            }
            return;
        }
        if (isRoot) {
            for (int i = from; i < to; i++) {
                double root = Math.sqrt(light) * highlight[i];
                sum[i] = sum[i] + light * (diffuse * lambert[i]) + specular * root * root;
            }
            return;
        }
        for (int i = from; i < to; i++) {
            sum[i] = sum[i] + light * (diffuse * lambert[i]) + light * (specular * highlight[i]);
        }
    }

    /**
     * Raises highlights to the power of s. Whole exponents are multiplied out: that rounds by at most 2u s, no more than what
     * an error of the highlight by 2u grows to.
     */
    private void raise(double[] highlight, double s, int from, int to) {
        int n = (int) Math.abs(s);
        double[] square = shadows.halfSquare;
        if (n != Math.abs(s) || n > MAX_MULTIPLIED) {
            for (int i = from; i < to; i++) {
                highlight[i] = shadows.unoccluded[i] ? Math.pow(highlight[i], s) : 0;
            }
            return;
        }
        System.arraycopy(highlight, from, square, from, to - from);
        Arrays.fill(highlight, from, to, 1);
        for (; n > 0; n >>= 1) {
            if ((n & 1) == 1) {
                Vectors.multiply(square, highlight, from, to);
            }
            Vectors.multiply(square, square, from, to);
        }
        if (s < 0) {
            for (int i = from; i < to; i++) {
                highlight[i] = 1 / highlight[i];
            }
        }
    }
}
