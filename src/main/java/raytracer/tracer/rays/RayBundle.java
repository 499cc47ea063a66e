package raytracer.tracer.rays;

import raytracer.scene.Vector;

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

    private final RayIntervals intervals = new RayIntervals();

    private final Vector[] origin = new Vector[CORNERS];
    private final Vector[] direction = new Vector[CORNERS];

    /** Where corner rays end or start, and the normals there, on the side where the rays are; null if nowhere. */
    private final Vector[] point = new Vector[CORNERS];
    private final Vector[] normal = new Vector[CORNERS];

    private Vector apex;
    private Vector axis;
    private double apexRadius;
    private double halfAngle;

    /** Where its rays are; whoever adds rays to an empty bundle includes them here. */
    public RayIntervals intervals() {
        return intervals;
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

    /** Widens the intervals and finds the cone; the corners must have been set, and all rays included. */
    public void close() {
        widen(intervals.minOrigin, intervals.maxOrigin);
        widen(intervals.minDirection, intervals.maxDirection);
        intervals.maxDistance *= 1 + MARGIN;
        Vector low = vector(intervals.minOrigin), high = vector(intervals.maxOrigin);
        apex = low.minus(low.minus(high).times(0.5));
        apexRadius = high.minus(low).length() / 2;
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

    private static void widen(double[] min, double[] max) {
        for (int side = 0; side < 3; side++) {
            double margin = MARGIN * (max[side] - min[side]);
            min[side] -= margin;
            max[side] += margin;
        }
    }

    private static Vector vector(double[] v) {
        return new Vector(v[0], v[1], v[2]);
    }

    /** Whether it is certain that no ray hits a sphere, or only behind its own surface. */
    public boolean isClearOfSphere(Vector centre, double radius) {
        Vector way = centre.minus(apex);
        double distance = way.length(), reach = radius + apexRadius;
        return isBehind(centre, radius) || distance > reach
                && Math.acos(axis.dot(way) / distance) - Math.asin(reach / distance) > halfAngle;
    }

    /** Whether it is certain that no ray hits a triangle, or only behind its own surface. */
    public boolean isClearOfTriangle(Vector a, Vector b, Vector c) {
        return isBehind(a, 0) && isBehind(b, 0) && isBehind(c, 0)
                || isOutside(a, b, c) || isOutside(b, c, a) || isOutside(c, a, b);
    }

    /** Whether all points within a radius of this one are. */
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
