package raytracer.chart;

import raytracer.scene.Vector;

/** Moeller and Trumbore's triangle (Fast, Minimum Storage Ray/Triangle Intersection, 1997) on flat arrays. */
final class TriangleMethods {

    final int count;
    final double[] t;
    private final double[] data;
    private final float[] single;

    /** @param corners three a ray */
    TriangleMethods(Vector[] origin, Vector[] direction, Vector[] corners) {
        count = origin.length;
        t = new double[count];
        data = new double[15 * count];
        single = new float[15 * count];
        for (int i = 0; i < count; i++) {
            Vector a = corners[3 * i], e1 = corners[3 * i + 1].minus(a), e2 = corners[3 * i + 2].minus(a);
            Vector[] all = {origin[i], direction[i], a, e1, e2};
            for (int k = 0; k < all.length; k++) {
                data[15 * i + 3 * k] = all[k].x();
                data[15 * i + 3 * k + 1] = all[k].y();
                data[15 * i + 3 * k + 2] = all[k].z();
            }
        }
        for (int i = 0; i < data.length; i++) {
            single[i] = (float) data[i];
        }
    }

    /** With this limit on the determinant. */
    double inDouble(double epsilon) {
        double[] q = data;
        for (int i = 0, at = 0; i < count; i++, at += 15) {
            t[i] = Double.NaN;
            double dx = q[at + 3], dy = q[at + 4], dz = q[at + 5];
            double ax = q[at + 9], ay = q[at + 10], az = q[at + 11], bx = q[at + 12], by = q[at + 13], bz = q[at + 14];
            double px = dy * bz - dz * by, py = dz * bx - dx * bz, pz = dx * by - dy * bx;
            double determinant = ax * px + ay * py + az * pz;
            if (Math.abs(determinant) <= epsilon) {
                continue;
            }
            double sx = q[at] - q[at + 6], sy = q[at + 1] - q[at + 7], sz = q[at + 2] - q[at + 8];
            double inverse = 1 / determinant;
            double u = (sx * px + sy * py + sz * pz) * inverse;
            if (u < 0 || u > 1) {
                continue;
            }
            double wx = sy * az - sz * ay, wy = sz * ax - sx * az, wz = sx * ay - sy * ax;
            double v = (dx * wx + dy * wy + dz * wz) * inverse;
            if (v < 0 || u + v > 1) {
                continue;
            }
            double distance = (bx * wx + by * wy + bz * wz) * inverse;
            if (distance > 0) {
                t[i] = distance;
            }
        }
        return t[0];
    }

    /** In floats, no limit. */
    double inFloat() {
        float[] q = single;
        for (int i = 0, at = 0; i < count; i++, at += 15) {
            t[i] = Double.NaN;
            float dx = q[at + 3], dy = q[at + 4], dz = q[at + 5];
            float ax = q[at + 9], ay = q[at + 10], az = q[at + 11], bx = q[at + 12], by = q[at + 13], bz = q[at + 14];
            float px = dy * bz - dz * by, py = dz * bx - dx * bz, pz = dx * by - dy * bx;
            float determinant = ax * px + ay * py + az * pz;
            if (determinant == 0) {
                continue;
            }
            float sx = q[at] - q[at + 6], sy = q[at + 1] - q[at + 7], sz = q[at + 2] - q[at + 8];
            float inverse = 1 / determinant;
            float u = (sx * px + sy * py + sz * pz) * inverse;
            if (u < 0 || u > 1) {
                continue;
            }
            float wx = sy * az - sz * ay, wy = sz * ax - sx * az, wz = sx * ay - sy * ax;
            float v = (dx * wx + dy * wy + dz * wz) * inverse;
            if (v < 0 || u + v > 1) {
                continue;
            }
            float distance = (bx * wx + by * wy + bz * wz) * inverse;
            if (distance > 0) {
                t[i] = distance;
            }
        }
        return t[0];
    }
}
