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

    // In units of half a pixel, at the distance where the picture has as many of them as pixels. Unlike a pixel's
    // share of the height, these are whole numbers if the camera looks along an axis and its field of view is 90.
    private final Vector right;
    private final Vector up;
    private final Vector backward;

    Pinhole(Scene scene) {
        Camera camera = scene.camera();
        width = scene.width();
        height = scene.height();
        eye = camera.eye();
        Vector toEye = camera.backward();
        // StrictMath, so that every Java version and machine aims alike. 90 degrees are the one field of view whose
        // tangent is rational (Niven 1956), so that rays can meet edges exactly; radians would miss it by a bit.
        double halfHeight = camera.fov() == 90 ? 1 : StrictMath.tan(Math.toRadians(camera.fov() / 2));
        right = camera.right().times(halfHeight);
        up = toEye.cross(camera.right()).times(halfHeight);
        backward = toEye.times(height);
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** How rays get their directions, where their normals x and y are points of the picture. */
    Pass[] aiming(Rays rays) {
        return new Pass[] {
            new ThroughPoints(rays.nx, rays.ny, width, height, right, up, backward, rays.direction),
            new Pass.Length(rays.direction, rays.nz),
            new Pass.DivideByLength(rays.direction, rays.nz),
        };
    }

    /** Makes the rays through some of these points: a ray's pixel is the number of its sample. */
    void aim(Rays rays, Pass[] aiming, Samples samples, int from, int count) {
        rays.count = count;
        rays.leaveEye = true;
        System.arraycopy(samples.x, from, rays.nx, 0, count);
        System.arraycopy(samples.y, from, rays.ny, 0, count);
        Pass.run(aiming, 0, count);
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

    /** Directions through points of the picture. */
    private record ThroughPoints(double[] x, double[] y, double width, double height,
            Vector right, Vector up, Vector backward, Vectors out) implements Pass {
        @Override
        public void run(int from, int to) {
            component(right.x(), up.x(), backward.x(), out.x(), from, to);
            component(right.y(), up.y(), backward.y(), out.y(), from, to);
            component(right.z(), up.z(), backward.z(), out.z(), from, to);
        }

        /** Twice the position less the size is exact for pixels' centres in a picture of any size. */
        private void component(double toRight, double toTop, double toEye, double[] out, int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = (2 * x[i] - width) * toRight + (height - 2 * y[i]) * toTop - toEye;
            }
        }
    }
}
