package raytracer.tracer.rays;

import java.util.Arrays;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;

/**
 * A tile's rays, one array per quantity, and what they have hit. The rays in use are the first {@link #count}; each
 * belongs to one sample of the batch.
 */
public final class Rays {

    /** In place of a surface's index: the ray leaves the eye, or it hits nothing. */
    public static final int NONE = -1;

    public int count;

    /** Whether all start at the eye: then they have their origin in common, and leave no surface. */
    public boolean leaveEye;

    /** What directions from the eye are the sums of. */
    public CameraAxes axes;

    // By axis, the intervals of directions from the eye, before they are normalised.
    public final double[] minEyeDirection = new double[3];
    public final double[] maxEyeDirection = new double[3];

    public final int[] sample = new int[Batch.CAPACITY];

    // Where each starts, and bounds on how far off that is: along the way on which the ray came there (once mirrored,
    // along the ray itself), and apart from that. The index of the surface it leaves.
    public final double[] ox = new double[Batch.CAPACITY];
    public final double[] oy = new double[Batch.CAPACITY];
    public final double[] oz = new double[Batch.CAPACITY];
    public final double[] originError = new double[Batch.CAPACITY];
    public final double[] slide = new double[Batch.CAPACITY];
    public final int[] source = new int[Batch.CAPACITY];

    // Where it goes: a unit vector, and a bound on the error of each coordinate.
    public final double[] dx = new double[Batch.CAPACITY];
    public final double[] dy = new double[Batch.CAPACITY];
    public final double[] dz = new double[Batch.CAPACITY];
    public final double[] directionError = new double[Batch.CAPACITY];

    // The nearest surface so far, and its distance.
    public final int[] hit = new int[Batch.CAPACITY];
    public final double[] distance = new double[Batch.CAPACITY];

    /** The rays that have hit several surfaces at about the same distance. */
    public final int[] close = new int[Batch.CAPACITY];
    public int closeCount;
    /** By ray, that distance; negative if there is none. */
    public final double[] closeDistance = new double[Batch.CAPACITY];

    // The unit normal where the ray has arrived, and a bound on the error of each coordinate.
    public final double[] nx = new double[Batch.CAPACITY];
    public final double[] ny = new double[Batch.CAPACITY];
    public final double[] nz = new double[Batch.CAPACITY];
    public final double[] normalError = new double[Batch.CAPACITY];

    // How much of the light that comes along the ray reaches the pixel: all of it, from the eye.
    public final double[] red = new double[Batch.CAPACITY];
    public final double[] green = new double[Batch.CAPACITY];
    public final double[] blue = new double[Batch.CAPACITY];

    // The same arrays as vectors.
    public final Vectors origin = new Vectors(ox, oy, oz);
    public final Vectors direction = new Vectors(dx, dy, dz);
    public final Vectors normal = new Vectors(nx, ny, nz);

    // What moves with a ray.
    private final double[][] ofEyeRays = {dx, dy, dz, distance};
    private final double[][] ofLaterRays =
            {dx, dy, dz, distance, ox, oy, oz, originError, directionError, red, green, blue};
    private final double[][] ofArrivedRays = {nx, ny, nz, normalError, slide};
    private final double[] selected = new double[Batch.CAPACITY];
    private final int[] selectedInts = new int[Batch.CAPACITY];

    public Rays() {
        Arrays.fill(closeDistance, -1);
    }

    /** Starts with rays of so many samples, from one on; they are yet to be aimed. Each knows its sample's number. */
    public void start(int from, int number) {
        count = number;
        leaveEye = true;
        Arrays.fill(source, 0, count, NONE);
        Arrays.fill(red, 0, count, 1);
        Arrays.fill(green, 0, count, 1);
        Arrays.fill(blue, 0, count, 1);
        for (int i = 0; i < count; i++) {
            sample[i] = from + i;
        }
    }

    /** Sets where a ray starts and where it goes, and that it is one of this batch. */
    public void set(int ray, Vector from, Vector unit) {
        count = Math.max(count, ray + 1);
        ox[ray] = from.x();
        oy[ray] = from.y();
        oz[ray] = from.z();
        dx[ray] = unit.x();
        dy[ray] = unit.y();
        dz[ray] = unit.z();
    }

    /** Forgets what was hit. */
    public void clearHits() {
        Arrays.fill(hit, 0, count, NONE);
        Arrays.fill(distance, 0, count, Double.POSITIVE_INFINITY);
    }

    /** The distance beyond which no hit can be, or tie with, the nearest of a ray. */
    public double maxDistance(int ray) {
        return distance[ray] * (1 + Rounding.TIE_SIEVE);
    }

    /**
     * By coordinate of a direction from the eye, the magnitudes that it is the sum of; null if it does not leave the eye, as
     * then its error has other sources.
     */
    public Vector directionTerms(int ray) {
        return leaveEye && axes != null ? axes.terms(direction.get(ray)) : null;
    }

    /** Records that a ray hits a surface, at a distance of {@link #maxDistance} at most. */
    public void record(int ray, int surface, double t) {
        if (t >= distance[ray] * (1 - Rounding.TIE_SIEVE)) {
            recordClose(ray);
        }
        if (t < distance[ray]) {
            hit[ray] = surface;
            distance[ray] = t;
        }
    }

    /** Records that a ray hits something else about where its nearest surface is. */
    private void recordClose(int ray) {
        if (closeDistance[ray] < 0) {
            close[closeCount++] = ray;
        }
        closeDistance[ray] = distance[ray];
    }

    /**
     * Moves a ray's origin to where it has hit a plane or triangle.
     *
     * @param products as for {@link Rounding#planeOffset}, seen from the old origin
     */
    public void moveToPlane(int ray, double products, double normalX, double normalY, double normalZ) {
        double t = distance[ray];
        double cosine = dx[ray] * normalX + dy[ray] * normalY + dz[ray] * normalZ;
        ox[ray] += t * dx[ray];
        oy[ray] += t * dy[ray];
        oz[ray] += t * dz[ray];
        double sink = Rounding.planeSink(products, t), granted = Rounding.slide(sink / Math.abs(cosine), t);
        slide[ray] = granted;
        originError[ray] = Rounding.point(t, Math.abs(ox[ray]) + Math.abs(oy[ray]) + Math.abs(oz[ray]))
                + Math.max(0, sink - granted * Math.abs(cosine));
        nx[ray] = normalX;
        ny[ray] = normalY;
        nz[ray] = normalZ;
        normalError[ray] = 2 * Rounding.U;
    }

    /** Turns all rays, which have arrived, into their mirror images: d - 2 (n . d) n. */
    public void mirror() {
        for (int i = 0; i < count; i++) {
            double twice = -2 * (dx[i] * nx[i] + dy[i] * ny[i] + dz[i] * nz[i]);
            double x = dx[i] + twice * nx[i], y = dy[i] + twice * ny[i], z = dz[i] + twice * nz[i];
            // Its length is 1 but for rounding, which would add up from mirror to mirror.
            double reciprocal = 1 / Math.sqrt(x * x + y * y + z * z);
            dx[i] = x * reciprocal;
            dy[i] = y * reciprocal;
            dz[i] = z * reciprocal;
            directionError[i] += Rounding.turn(normalError[i]);
            // What slides along the old way slides along the new one, and twice as far as the old one goes down.
            originError[i] += 2 * slide[i] * Math.abs(dx[i] * nx[i] + dy[i] * ny[i] + dz[i] * nz[i]);
        }
        System.arraycopy(hit, 0, source, 0, count);
    }

    /** Keeps some of the rays that have hit something, in a new order; nothing is known yet of where they arrive. */
    public void select(int[] order, int kept) {
        select(sample, order, kept);
        select(hit, order, kept);
        // The other quantities are the same for all that leave the eye; and the next source is what was hit.
        select(leaveEye ? ofEyeRays : ofLaterRays, order, kept);
        count = kept;
    }

    /** Keeps some of the rays that have arrived, in a new order. */
    public void selectArrived(int[] order, int kept) {
        select(order, kept);
        select(ofArrivedRays, order, kept);
    }

    private void select(double[][] quantities, int[] order, int kept) {
        for (double[] quantity : quantities) {
            select(quantity, order, kept);
        }
    }

    private void select(double[] quantity, int[] order, int kept) {
        for (int i = 0; i < kept; i++) {
            selected[i] = quantity[order[i]];
        }
        System.arraycopy(selected, 0, quantity, 0, kept);
    }

    private void select(int[] quantity, int[] order, int kept) {
        for (int i = 0; i < kept; i++) {
            selectedInts[i] = quantity[order[i]];
        }
        System.arraycopy(selectedInts, 0, quantity, 0, kept);
    }
}
