package raytracer.tracer;

import raytracer.scene.Camera;
import raytracer.scene.Scene;
import raytracer.scene.Vector;
import raytracer.tracer.kernel.Kernel;
import raytracer.tracer.kernel.Rounding;
import raytracer.tracer.rays.Rays;

/** The rays of a scene's camera. */
final class Pinhole {

    private final Camera camera;
    private final int width;
    private final int height;
    private final Vector eye;

    // In units of half a pixel, at the distance where the picture has as many of them as pixels. Unlike a pixel's
    // share of the height, these are whole numbers if the camera looks along an axis and its field of view is 90.
    private final Vector right;
    private final Vector up;
    private final Vector backward;

    Pinhole(Scene scene) {
        this(scene.camera(), scene.width(), scene.height());
    }

    private Pinhole(Camera camera, int width, int height) {
        this.camera = camera;
        this.width = width;
        this.height = height;
        eye = camera.eye();
        Vector toEye = camera.backward();
        // StrictMath, so that every Java version and machine aims alike. 90 degrees are the one field of view whose
        // tangent is rational (Niven 1956), so that rays can hit edges exactly; radians would miss it by a bit.
        double halfHeight = camera.fov() == 90 ? 1 : StrictMath.tan(Math.toRadians(camera.fov() / 2));
        right = camera.right().times(halfHeight);
        up = toEye.cross(camera.right()).times(halfHeight);
        backward = toEye.times(height);
    }

    /** The same view in a picture so many times as wide and as high. */
    Pinhole enlarged(int factor) {
        return new Pinhole(camera, Math.multiplyExact(factor, width), Math.multiplyExact(factor, height));
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** What makes rays leave the eye, through points of the picture that are in place of their normals' x and y. */
    Kernel aiming(Rays rays) {
        return new Kernel.InTurn(
                // Twice the position less the size is exact for pixels' centres in a picture of any size.
                new Kernel.Linear(rays.nx, 2, -width),
                new Kernel.Linear(rays.ny, -2, height),
                new Component(rays.nx, rays.ny, right.x(), up.x(), backward.x(), rays.dx),
                new Component(rays.nx, rays.ny, right.y(), up.y(), backward.y(), rays.dy),
                new Component(rays.nx, rays.ny, right.z(), up.z(), backward.z(), rays.dz),
                new Kernel.Length(rays.direction, rays.nz),
                new Kernel.DivideByLength(rays.direction, rays.nz),
                new Kernel.Fill(rays.directionError, Rounding.EYE_DIRECTION),
                new Kernel.Fill(rays.ox, eye.x()),
                new Kernel.Fill(rays.oy, eye.y()),
                new Kernel.Fill(rays.oz, eye.z()),
                new Kernel.Fill(rays.originError, 0),
                new Kernel.Fill(rays.slide, 0));
    }

    /** Of directions. */
    private record Component(double[] x, double[] y, double toRight, double toTop, double toEye, double[] out)
            implements Kernel {
        @Override
        public void run(int from, int to) {
            for (int i = from; i < to; i++) {
                out[i] = x[i] * toRight + y[i] * toTop - toEye;
            }
        }
    }
}
