package raytracer.tracer;

import java.util.Arrays;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;

/**
 * Traces tiles, one after the other, for one thread. All of a tile's rays take each step together: they find the
 * nearest surface, move there, are shaded, and turn into their mirror images, as often as the depth allows. A ray
 * leaves the tile when it meets nothing or can no longer change its pixel.
 */
public final class TileTracer {

    /** The greatest whole exponent that is multiplied out. */
    private static final int MOST_MULTIPLIED = 1024;

    private final Pinhole pinhole;
    private final List<Surfaces> surfaces;
    private final Material[] material;
    private final List<Lamp> lamps;
    private final int maxDepth;

    private final Scratch scratch = new Scratch();
    private final Rays rays;
    private final ShadowRays shadows = new ShadowRays();

    // By ray: the light that its surface sends back along it.
    private final double[] shadeRed = new double[Rays.CAPACITY];
    private final double[] shadeGreen = new double[Rays.CAPACITY];
    private final double[] shadeBlue = new double[Rays.CAPACITY];

    // By pixel of the tile.
    private final double[] red = new double[Rays.CAPACITY];
    private final double[] green = new double[Rays.CAPACITY];
    private final double[] blue = new double[Rays.CAPACITY];

    private long primaryCount;
    private long shadowCount;
    private long reflectionCount;

    TileTracer(Pinhole pinhole, List<Surfaces> surfaces, SlotTable slots, List<Lamp> lamps, int maxDepth) {
        this.pinhole = pinhole;
        this.surfaces = surfaces;
        this.material = slots.material();
        this.lamps = lamps;
        this.maxDepth = maxDepth;
        rays = new Rays(slots.declared(), surfaces);
    }

    /**
     * Traces a rectangle of at most {@link Tracer#TILE_SIDE} pixels on each side.
     *
     * @param sink gets every pixel of the rectangle once
     */
    public void trace(int left, int top, int columns, int rows, PixelSink sink) {
        Arrays.fill(red, 0);
        Arrays.fill(green, 0);
        Arrays.fill(blue, 0);
        pinhole.aim(rays, left, top, columns, rows);
        primaryCount += rays.count;
        for (int depth = 1; rays.count > 0; depth++) {
            findNearest();
            shade();
            if (depth == maxDepth) {
                break;
            }
            reflect();
            reflectionCount += rays.count;
        }
        for (int i = 0; i < columns * rows; i++) {
            sink.set(left + i % columns, top + i / columns, red[i], green[i], blue[i]);
        }
    }

    /** What this has traced since it was made. */
    public RayCounts counts() {
        return new RayCounts(primaryCount, shadowCount, reflectionCount);
    }

    /** Takes every ray to the nearest surface; those that meet none leave. */
    private void findNearest() {
        rays.clearHits();
        for (Surfaces kind : surfaces) {
            kind.findNearest(rays, scratch);
        }
        int kept = 0;
        for (int i = 0; i < rays.count; i++) {
            if (rays.hit[i] != Rays.NONE) {
                rays.move(i, kept++);
            }
        }
        rays.count = kept;
        for (Surfaces kind : surfaces) {
            for (int i = 0; i < kept; i++) {
                if (kind.owns(rays.hit[i])) {
                    kind.arrive(rays, i);
                }
            }
        }
    }

    private void shade() {
        for (int i = 0; i < rays.count; i++) {
            Colour ambient = material[rays.hit[i]].ambient();
            shadeRed[i] = ambient.red();
            shadeGreen[i] = ambient.green();
            shadeBlue[i] = ambient.blue();
        }
        for (Lamp lamp : lamps) {
            shadows.lamp = lamp;
            for (int i = 0; i < rays.count; i++) {
                aimAtLamp(i);
                shadowCount += shadows.open[i] ? 1 : 0;
            }
            for (Surfaces kind : surfaces) {
                kind.block(rays, shadows, scratch);
            }
            for (int i = 0; i < rays.count; i++) {
                if (shadows.open[i]) {
                    addLight(i, lamp.colour());
                }
            }
        }
        for (int i = 0; i < rays.count; i++) {
            int p = rays.pixel[i];
            red[p] += times(rays.red[i], shadeRed[i]);
            green[p] += times(rays.green[i], shadeGreen[i]);
            blue[p] += times(rays.blue[i], shadeBlue[i]);
        }
    }

    /** Makes the shadow ray from where ray i has arrived; it is open if the light would add something there. */
    private void aimAtLamp(int i) {
        Lamp lamp = shadows.lamp;
        double lx = lamp.x(), ly = lamp.y(), lz = lamp.z();
        double distance = Double.POSITIVE_INFINITY;
        if (!lamp.directional()) {
            lx -= rays.ox[i];
            ly -= rays.oy[i];
            lz -= rays.oz[i];
            distance = Math.sqrt(lx * lx + ly * ly + lz * lz);
            lx /= distance;
            ly /= distance;
            lz /= distance;
        }
        shadows.dx[i] = lx;
        shadows.dy[i] = ly;
        shadows.dz[i] = lz;
        shadows.distance[i] = distance;
        double nx = rays.nx[i], ny = rays.ny[i], nz = rays.nz[i];
        // The half vector, not yet of length 1.
        double hx = lx - rays.dx[i], hy = ly - rays.dy[i], hz = lz - rays.dz[i];
        double square = hx * hx + hy * hy + hz * hz;
        double highlight = square > 0 ? (nx * hx + ny * hy + nz * hz) / Math.sqrt(square) : 0;
        double lambert = nx * lx + ny * ly + nz * lz;
        shadows.highlight[i] = highlight;
        shadows.lambert[i] = lambert;
        Material m = material[rays.hit[i]];
        shadows.open[i] = distance > 0
                && (lambert > 0 && !m.diffuse().isBlack()
                        || (highlight > 0 || m.shininess() <= 0) && !m.specular().isBlack());
    }

    private void addLight(int i, Colour light) {
        Material m = material[rays.hit[i]];
        double lambert = shadows.lambert[i] > 0 ? shadows.lambert[i] : 0;
        double cosine = shadows.highlight[i];
        double highlight = power(cosine > 1 ? 1 : cosine > 0 ? cosine : 0, m.shininess());
        shadeRed[i] += light.red() * (m.diffuse().red() * lambert)
                + times(light.red(), times(m.specular().red(), highlight));
        shadeGreen[i] += light.green() * (m.diffuse().green() * lambert)
                + times(light.green(), times(m.specular().green(), highlight));
        shadeBlue[i] += light.blue() * (m.diffuse().blue() * lambert)
                + times(light.blue(), times(m.specular().blue(), highlight));
    }

    /**
     * x to the s, x from 0 to 1. Whole exponents are multiplied out: that rounds by at most 2u s, no more than what an
     * error of x by 2u grows to.
     */
    private static double power(double x, double s) {
        int n = (int) s;
        if (n != s || n < 0 || n > MOST_MULTIPLIED) {
            return Math.pow(x, s);
        }
        double result = 1;
        for (double factor = x; n > 0; n >>= 1) {
            if ((n & 1) == 1) {
                result *= factor;
            }
            factor *= factor;
        }
        return result;
    }

    /** Turns every ray into its mirror image; those that cannot change their pixel any more leave. */
    private void reflect() {
        int kept = 0;
        for (int i = 0; i < rays.count; i++) {
            Colour mirror = material[rays.hit[i]].specular();
            rays.red[i] = times(rays.red[i], mirror.red());
            rays.green[i] = times(rays.green[i], mirror.green());
            rays.blue[i] = times(rays.blue[i], mirror.blue());
            if (canChange(i)) {
                rays.mirror(i);
                rays.move(i, kept++);
            }
        }
        rays.count = kept;
    }

    private boolean canChange(int i) {
        int p = rays.pixel[i];
        return rays.red[i] > 0 && red[p] < 1 || rays.green[i] > 0 && green[p] < 1 || rays.blue[i] > 0 && blue[p] < 1;
    }

    /** A product in which nothing of something infinite is nothing: an infinite highlight, a black component. */
    private static double times(double a, double b) {
        return a == 0 || b == 0 ? 0 : a * b;
    }
}
