package raytracer.tracer;

import java.util.Arrays;
import raytracer.scene.Camera;
import raytracer.scene.Scene;
import raytracer.scene.Vector;

/** The rays of a scene's camera. */
final class Pinhole {

    private final int width;
    private final int height;
    private final Vector eye;
    private final Vector right;
    private final Vector up;
    private final Vector backward;
    private final double halfHeight;

    Pinhole(Scene scene) {
        Camera camera = scene.camera();
        width = scene.width();
        height = scene.height();
        eye = camera.eye();
        backward = camera.backward();
        right = camera.right();
        up = backward.cross(right);
        // StrictMath, so that every Java version and machine aims alike. 90 degrees are the one field of view whose
        // tangent is rational (Niven 1956), so that rays can meet edges exactly; radians would miss it by a bit.
        halfHeight = camera.fov() == 90 ? 1 : StrictMath.tan(Math.toRadians(camera.fov() / 2));
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Makes the rays through some of these points: a ray's pixel is the number of its sample. */
    void aim(Rays rays, Samples samples, int from, int count) {
        rays.count = count;
        rays.leaveEye = true;
        inUnitsOfDistance(samples.x, samples.y, from, rays.nx, rays.ny, count);
        component(rays.nx, rays.ny, right.x(), up.x(), backward.x(), rays.dx, count);
        component(rays.nx, rays.ny, right.y(), up.y(), backward.y(), rays.dy, count);
        component(rays.nx, rays.ny, right.z(), up.z(), backward.z(), rays.dz, count);
        Passes.length(rays.dx, rays.dy, rays.dz, rays.nz, 0, count);
        Passes.divide(rays.dx, rays.dy, rays.dz, rays.nz, 0, count);
        Arrays.fill(rays.directionError, 0, count, Rounding.EYE_DIRECTION);
        Arrays.fill(rays.ox, 0, count, eye.x());
        Arrays.fill(rays.oy, 0, count, eye.y());
        Arrays.fill(rays.oz, 0, count, eye.z());
        Arrays.fill(rays.originError, 0, count, 0);
        Arrays.fill(rays.source, 0, count, Rays.NONE);
        Arrays.fill(rays.red, 0, count, 1);
        Arrays.fill(rays.green, 0, count, 1);
        Arrays.fill(rays.blue, 0, count, 1);
        for (int i = 0; i < count; i++) {
            rays.pixel[i] = from + i;
        }
    }

    /** Twice the position less the size is exact for pixels' centres in a picture of any size. */
    private void inUnitsOfDistance(double[] x, double[] y, int from, double[] a, double[] b, int count) {
        double w = width, h = height;
        for (int i = 0; i < count; i++) {
            a[i] = halfHeight * ((2 * x[from + i] - w) / h);
        }
        for (int i = 0; i < count; i++) {
            b[i] = halfHeight * ((h - 2 * y[from + i]) / h);
        }
    }

    private static void component(double[] a, double[] b, double right, double up, double backward, double[] out,
            int count) {
        for (int i = 0; i < count; i++) {
            out[i] = a[i] * right + b[i] * up - backward;
        }
    }
}
