package raytracer.tracer;

import java.util.Arrays;
import raytracer.scene.Camera;
import raytracer.scene.Scene;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.arithmetic.Vectors;
import raytracer.tracer.rays.CameraAxes;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;

/** The rays of a scene's camera. */
final class Pinhole {

    private final int width;
    private final int height;
    private final Vector eye;
    private final CameraAxes axes;

    // In units of half a pixel, at the distance where the picture has as many of them as pixels. Unlike a pixel's
    // share of the height, these are whole numbers if the camera looks along an axis and its field of view is 90.
    private final Vector right;
    private final Vector up;
    private final Vector backward;

    Pinhole(Scene scene) {
        width = scene.width();
        height = scene.height();
        Camera camera = scene.camera();
        eye = camera.eye();
        axes = CameraAxes.of(camera);
        // StrictMath, so that every Java version and machine aims alike. 90 degrees are the one field of view whose
        // tangent is rational (Niven 1956), so that rays can hit edges exactly; radians would miss it by a bit.
        double halfHeight = camera.fov() == 90 ? 1 : StrictMath.tan(Math.toRadians(camera.fov() / 2));
        right = axes.right().times(halfHeight);
        up = axes.up().times(halfHeight);
        backward = axes.backward().times(height);
    }

    /** Makes rays leave the eye through their samples' points. @param from the first ray's sample */
    void aim(Rays rays, Samples samples, int from) {
        int to = rays.count;
        direct(samples, from, rays.direction, to);
        setIntervals(rays, samples.bounds);
        rays.axes = axes;
        // Nothing is hit yet: the distances have room for the lengths.
        rays.direction.normalise(rays.distance, 0, to);
        Arrays.fill(rays.directionError, 0, to, Rounding.EYE_DIRECTION);
        Arrays.fill(rays.ox, 0, to, eye.x());
        Arrays.fill(rays.oy, 0, to, eye.y());
        Arrays.fill(rays.oz, 0, to, eye.z());
        Arrays.fill(rays.originError, 0, to, 0);
        Arrays.fill(rays.slide, 0, to, 0);
    }

    private void direct(Samples samples, int from, Vectors direction, int to) {
        double[] x = samples.x, y = samples.y, dx = direction.x(), dy = direction.y(), dz = direction.z();
        double rx = right.x(), ry = right.y(), rz = right.z(), ux = up.x(), uy = up.y(), uz = up.z();
        double bx = backward.x(), by = backward.y(), bz = backward.z();
        for (int i = 0; i < to; i++) {
            // Twice the position less the size is exact for pixels' centres in a picture of any size.
            double a = 2 * x[from + i] - width, b = height - 2 * y[from + i];
            dx[i] = a * rx + b * ux - bx;
            dy[i] = a * ry + b * uy - by;
            dz[i] = a * rz + b * uz - bz;
        }
    }

    /** The directions' intervals, in units of what is computed above: each is greatest and least at a corner. */
    private void setIntervals(Rays rays, double[] bounds) {
        for (int axis = 0; axis < 3; axis++) {
            double r = right.coordinate(axis), u = up.coordinate(axis);
            double a = 2 * bounds[0] - width, b = 2 * bounds[1] - width, c = height - 2 * bounds[3], d = height - 2 * bounds[2];
            rays.minEyeDirection[axis] = (r > 0 ? a : b) * r + (u > 0 ? c : d) * u - backward.coordinate(axis);
            rays.maxEyeDirection[axis] = (r > 0 ? b : a) * r + (u > 0 ? d : c) * u - backward.coordinate(axis);
        }
    }
}
