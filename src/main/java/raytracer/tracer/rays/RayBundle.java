package raytracer.tracer.rays;

import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Vectors;

/**
 * All rays through a part of the picture, or from a part of a surface to a light: four of them are its corners, and a
 * box of origins, a box of directions and a cone hold the others. A part of the picture is seen from one point, and
 * what a corner ray and its neighbour have on one side, the rays between them have too.
 */
public final class RayBundle {

    public static final int CORNERS = 4;

    /**
     * By which part of themselves boxes and cones are widened: rays between those that are known may differ by more, if
     * a curved surface sends them.
     */
    private static final double MARGIN = 1 / 16.0;

    /**
     * Of a distance to a surface: a point within it counts as being on the surface's tangent plane, as rounding
     * leaves it.
     */
    private static final double ON_PLANE = 0x1p-36;

    // By axis.
    public final double[] minOrigin = new double[3];
    public final double[] maxOrigin = new double[3];
    public final double[] minDirection = new double[3];
    public final double[] maxDirection = new double[3];

    /** What is farther away does not matter. */
    public double maxDistance;

    private final Vector[] origin = new Vector[CORNERS];
    private final Vector[] direction = new Vector[CORNERS];

    /** Where corner rays end or start, and the normals there, on the side where the rays are; null if nowhere. */
    private final Vector[] point = new Vector[CORNERS];
    private final Vector[] normal = new Vector[CORNERS];

    private Vector apex;
    private Vector axis;
    private double apexRadius;
    private double halfAngle;

    /** Makes the bundle empty. */
    public void clear() {
        for (int side = 0; side < 3; side++) {
            minOrigin[side] = minDirection[side] = Double.POSITIVE_INFINITY;
            maxOrigin[side] = maxDirection[side] = Double.NEGATIVE_INFINITY;
        }
        maxDistance = 0;
    }

    /** Lets rays, from one index to another, be some of the bundle. */
    public void include(Vectors origins, Vectors directions, double[] distances, int from, int to) {
        span(origins.x(), from, to, minOrigin, maxOrigin, 0);
        span(origins.y(), from, to, minOrigin, maxOrigin, 1);
        span(origins.z(), from, to, minOrigin, maxOrigin, 2);
        span(directions.x(), from, to, minDirection, maxDirection, 0);
        span(directions.y(), from, to, minDirection, maxDirection, 1);
        span(directions.z(), from, to, minDirection, maxDirection, 2);
        for (int i = from; i < to; i++) {
            maxDistance = Math.max(maxDistance, distances[i]);
        }
    }

    private static void span(double[] values, int from, int to, double[] min, double[] max, int side) {
        double low = min[side], high = max[side];
        for (int i = from; i < to; i++) {
            low = Math.min(low, values[i]);
            high = Math.max(high, values[i]);
        }
        min[side] = low;
        max[side] = high;
    }

    /**
     * Sets a corner ray.
     *
     * @param at on the surface that it hits or leaves; null if it hits nothing
     * @param n  that surface's unit normal there, on any side
     */
    public void setCorner(int corner, Vector from, Vector unit, Vector at, Vector n) {
        origin[corner] = from;
        direction[corner] = unit;
        point[corner] = at;
        if (at != null) {
            // Rays come from the side where they start, or leave to the side where they go.
            boolean isTurned = from.equals(at) ? n.dot(unit) < 0 : n.dot(unit) > 0;
            normal[corner] = isTurned ? n.times(-1) : n;
        }
    }

    /** Finds the hull of all rays that were included; the corners must have been set. */
    public void close() {
        double[] middle = new double[3];
        double square = 0;
        for (int side = 0; side < 3; side++) {
            widen(minOrigin, maxOrigin, side);
            widen(minDirection, maxDirection, side);
            middle[side] = (minOrigin[side] + maxOrigin[side]) / 2;
            square += (maxOrigin[side] - minOrigin[side]) * (maxOrigin[side] - minOrigin[side]) / 4;
        }
        maxDistance *= 1 + MARGIN;
        apex = new Vector(middle[0], middle[1], middle[2]);
        apexRadius = Math.sqrt(square);
        axis = new Vector(0, 0, 0);
        for (Vector d : direction) {
            axis = axis.minus(d.times(-1));
        }
        axis = axis.unit();
        double cosine = 1;
        for (Vector d : direction) {
            cosine = Math.min(cosine, axis.dot(d));
        }
        halfAngle = (1 + MARGIN) * Math.acos(cosine);
    }

    private static void widen(double[] min, double[] max, int side) {
        double margin = MARGIN * (max[side] - min[side]);
        min[side] -= margin;
        max[side] += margin;
    }

    /**
     * Whether it is certain that no ray hits the points within a radius of a triangle, or only behind its own
     * surface.
     */
    public boolean isClearOf(Vector a, Vector b, Vector c, double radius) {
        return isBehind(a, radius) && isBehind(b, radius) && isBehind(c, radius)
                || (radius > 0 ? isClearOfSphere(a, radius) : isClearOfTriangle(a, b, c));
    }

    private boolean isBehind(Vector v, double radius) {
        for (int corner = 0; corner < CORNERS; corner++) {
            if (point[corner] == null) {
                return false;
            }
            Vector way = v.minus(point[corner]);
            if (!(way.dot(normal[corner]) <= ON_PLANE * way.length() - radius)) {
                return false;
            }
        }
        return true;
    }

    private boolean isClearOfSphere(Vector centre, double radius) {
        Vector way = centre.minus(apex);
        double distance = way.length(), reach = radius + apexRadius;
        return distance > reach
                && Math.acos(axis.dot(way) / distance) - Math.asin(reach / distance) > halfAngle;
    }

    /** Whether all corner rays pass by the triangle outside of the same edge. */
    private boolean isClearOfTriangle(Vector a, Vector b, Vector c) {
        return isOutside(a, b, c) || isOutside(b, c, a) || isOutside(c, a, b);
    }

    /** Whether all corner rays pass the edge from a to b of a triangle on its outside. */
    private boolean isOutside(Vector a, Vector b, Vector c) {
        double turn = 0;
        for (int corner = 0; corner < CORNERS; corner++) {
            Vector u = a.minus(origin[corner]), v = b.minus(origin[corner]), w = c.minus(origin[corner]);
            Vector d = direction[corner];
            double ab = d.dot(u.cross(v)), all = Math.signum(ab + d.dot(v.cross(w)) + d.dot(w.cross(u)));
            if (turn * all < 0 || !(all * ab < 0)) {
                return false;
            }
            turn = all;
        }
        return true;
    }
}
