package raytracer.tracer.lightbuffer;

import java.util.ArrayList;
import java.util.List;
import raytracer.scene.Vector;

/**
 * What a picture shows.
 *
 * @param corners the directions of its corners, in their order around it
 */
public record Frustum(List<Vector> corners) {

    /** Sides of a face. */
    private static final int SIDES = 4;

    /** Limits a face around the eye to what is shown of it. */
    void limit(CubeFace face) {
        // A polygon of directions, by their depth, across and down; a side of it is what is between two directions.
        List<double[]> polygon = new ArrayList<>();
        for (Vector v : corners) {
            polygon.add(new double[] {face.depth(v.x(), v.y(), v.z()), face.across(v.x(), v.y(), v.z()),
                face.down(v.x(), v.y(), v.z())});
        }
        for (int side = 0; side < SIDES; side++) {
            polygon = clip(polygon, side);
        }
        double minU = Double.POSITIVE_INFINITY, minV = minU, maxU = -minU, maxV = -minU;
        for (double[] corner : polygon) {
            double u = corner[1] / corner[0], v = corner[2] / corner[0];
            minU = Math.min(minU, u);
            minV = Math.min(minV, v);
            maxU = Math.max(maxU, u);
            maxV = Math.max(maxV, v);
        }
        face.limit(minU, maxU, minV, maxV);
    }

    /** The part of a polygon that is inside of a side (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). */
    private static List<double[]> clip(List<double[]> polygon, int side) {
        List<double[]> inside = new ArrayList<>();
        for (int i = 0; i < polygon.size(); i++) {
            double[] from = polygon.get(i), to = polygon.get((i + 1) % polygon.size());
            double a = room(from, side), b = room(to, side);
            if (a >= 0) {
                inside.add(from);
            }
            if (a >= 0 != b >= 0) {
                double part = a / (a - b);
                double[] between = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    between[axis] = from[axis] + part * (to[axis] - from[axis]);
                }
                inside.add(between);
            }
        }
        return inside;
    }

    /** Negative if a direction is outside of a side. */
    private static double room(double[] direction, int side) {
        double beside = direction[1 + side / 2];
        return direction[0] + (side % 2 == 0 ? beside : -beside);
    }
}
