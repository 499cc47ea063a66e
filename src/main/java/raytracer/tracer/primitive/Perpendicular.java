package raytracer.tracer.primitive;

import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Vectors;

/**
 * The perpendicular from a sphere's centre c to rays: how far along a ray its origin is from the foot, by how much the
 * perpendicular's square is less than another, and where the ray hits the sphere. For rays from one point there are
 * kernels that do the same, to the last bit, with half of the arithmetic ({@link Vectors#dot}, {@link InsideOfOne}).
 */
public final class Perpendicular {

    private Perpendicular() { }

    /** along = (o - c) . d */
    record Along(Vectors origin, double cx, double cy, double cz, Vectors direction, double[] along) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] ox = origin.x(), oy = origin.y(), oz = origin.z();
            double[] dx = direction.x(), dy = direction.y(), dz = direction.z();
            for (int i = from; i < to; i++) {
                along[i] = (ox[i] - cx) * dx[i] + (oy[i] - cy) * dy[i] + (oz[i] - cz) * dz[i];
            }
        }
    }

    /** inside = max - |o - c - along d|^2 */
    record Inside(Vectors origin, double cx, double cy, double cz, double max, Vectors direction, double[] along,
            double[] inside) implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] ox = origin.x(), oy = origin.y(), oz = origin.z();
            double[] dx = direction.x(), dy = direction.y(), dz = direction.z();
            // Too large for C2 to vectorise, but three loops instead are hardly faster, and compiled later.
            for (int i = from; i < to; i++) {
                double ex = ox[i] - cx - along[i] * dx[i];
                double ey = oy[i] - cy - along[i] * dy[i];
                double ez = oz[i] - cz - along[i] * dz[i];
                inside[i] = max - (ex * ex + ey * ey + ez * ez);
            }
        }
    }

    /** inside = max - |(x, y, z) - along d|^2, where (x, y, z) is the o - c of all */
    record InsideOfOne(double x, double y, double z, double max, Vectors direction, double[] along, double[] inside)
            implements Kernel {
        @Override
        public void run(int from, int to) {
            double[] dx = direction.x(), dy = direction.y(), dz = direction.z();
            for (int i = from; i < to; i++) {
                double ex = x - along[i] * dx[i];
                double ey = y - along[i] * dy[i];
                double ez = z - along[i] * dz[i];
                inside[i] = max - (ex * ex + ey * ey + ez * ez);
            }
        }
    }

    /**
     * How far away rays that start at the same point outside a sphere first hit it, if they do: the same as
     * {@link Spheres} computes for one ray.
     *
     * @param power  of that point
     * @param inside with the square of the radius as its max
     */
    record Distance(double power, double[] along, double[] inside, double[] distance) implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                distance[i] = power / (Math.sqrt(Math.max(0, inside[i])) - along[i]);
            }
        }
    }
}
