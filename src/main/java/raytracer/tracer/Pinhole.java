package raytracer.tracer;

import raytracer.scene.Camera;
import raytracer.scene.Scene;
import raytracer.scene.Vector;

/** The rays of a scene's camera, each through the centre of its pixel. */
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

    /** Makes the rays of a rectangle of pixels, row by row: ray and pixel numbers agree. */
    void aim(Rays rays, int left, int top, int columns, int rows) {
        rays.count = columns * rows;
        for (int row = 0; row < rows; row++) {
            // The pixel's centre in half pixels from the picture's: exact in a double for any size of an int.
            double b = halfHeight * ((height - 1.0 - 2.0 * (top + row)) / height);
            for (int column = 0; column < columns; column++) {
                double a = halfHeight * ((2.0 * (left + column) + 1.0 - width) / height);
                aim(rays, row * columns + column, a, b);
            }
        }
    }

    private void aim(Rays rays, int i, double a, double b) {
        double x = a * right.x() + b * up.x() - backward.x();
        double y = a * right.y() + b * up.y() - backward.y();
        double z = a * right.z() + b * up.z() - backward.z();
        double length = Math.sqrt(x * x + y * y + z * z);
        rays.dx[i] = x / length;
        rays.dy[i] = y / length;
        rays.dz[i] = z / length;
        rays.directionError[i] = Rounding.EYE_DIRECTION;
        rays.ox[i] = eye.x();
        rays.oy[i] = eye.y();
        rays.oz[i] = eye.z();
        rays.originError[i] = 0;
        rays.source[i] = Rays.NONE;
        rays.pixel[i] = i;
        rays.red[i] = 1;
        rays.green[i] = 1;
        rays.blue[i] = 1;
    }
}
