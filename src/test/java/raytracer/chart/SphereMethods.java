package raytracer.chart;

import raytracer.scene.Vector;

/** Sphere kernels from textbooks, on flat arrays: each writes distances, NaN where nothing is met. */
final class SphereMethods {

    final int count;
    final double[] ox, oy, oz, dx, dy, dz, cx, cy, cz, r;
    final double[] t;
    private final float[][] f;

    SphereMethods(Vector[] origin, Vector[] direction, Vector[] centre, double[] radius) {
        count = origin.length;
        ox = new double[count];
        oy = new double[count];
        oz = new double[count];
        dx = new double[count];
        dy = new double[count];
        dz = new double[count];
        cx = new double[count];
        cy = new double[count];
        cz = new double[count];
        r = radius.clone();
        t = new double[count];
        f = new float[10][count];
        for (int i = 0; i < count; i++) {
            ox[i] = origin[i].x();
            oy[i] = origin[i].y();
            oz[i] = origin[i].z();
            dx[i] = direction[i].x();
            dy[i] = direction[i].y();
            dz[i] = direction[i].z();
            cx[i] = centre[i].x();
            cy[i] = centre[i].y();
            cz[i] = centre[i].z();
            double[] all = {ox[i], oy[i], oz[i], dx[i], dy[i], dz[i], cx[i], cy[i], cz[i], r[i]};
            for (int k = 0; k < all.length; k++) {
                f[k][i] = (float) all[k];
            }
        }
    }

    /** The quadratic formula. */
    double quadratic() {
        for (int i = 0; i < count; i++) {
            double x = ox[i] - cx[i], y = oy[i] - cy[i], z = oz[i] - cz[i];
            double b = x * dx[i] + y * dy[i] + z * dz[i];
            double c = x * x + y * y + z * z - r[i] * r[i];
            t[i] = nearest(b, b * b - c);
        }
        return t[0];
    }

    /** The discriminant from the perpendicular; the distance still as a plain difference. */
    double perpendicular() {
        for (int i = 0; i < count; i++) {
            double x = ox[i] - cx[i], y = oy[i] - cy[i], z = oz[i] - cz[i];
            double b = x * dx[i] + y * dy[i] + z * dz[i];
            double ex = x - b * dx[i], ey = y - b * dy[i], ez = z - b * dz[i];
            t[i] = nearest(b, r[i] * r[i] - (ex * ex + ey * ey + ez * ez));
        }
        return t[0];
    }

    private static double nearest(double b, double discriminant) {
        if (discriminant < 0) {
            return Double.NaN;
        }
        double root = Math.sqrt(discriminant);
        double near = -b - root;
        if (near > 0) {
            return near;
        }
        return root - b > 0 ? root - b : Double.NaN;
    }

    /** The quadratic formula in floats. */
    double inFloat() {
        for (int i = 0; i < count; i++) {
            float x = f[0][i] - f[6][i], y = f[1][i] - f[7][i], z = f[2][i] - f[8][i];
            float b = x * f[3][i] + y * f[4][i] + z * f[5][i];
            float c = x * x + y * y + z * z - f[9][i] * f[9][i];
            float discriminant = b * b - c;
            if (discriminant < 0) {
                t[i] = Double.NaN;
                continue;
            }
            float root = (float) Math.sqrt(discriminant);
            float near = -b - root, far = root - b;
            t[i] = near > 0 ? near : far > 0 ? far : Double.NaN;
        }
        return t[0];
    }
}
