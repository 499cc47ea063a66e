package raytracer.tracer.rays;

import raytracer.tracer.arithmetic.Vectors;

/** By axis, the intervals in which the origins and the directions of many rays lie. */
public final class RayIntervals {

    public final double[] minOrigin = new double[3];
    public final double[] maxOrigin = new double[3];

    // In a unit that is the rays' own: their directions may be longer than 1.
    public final double[] minDirection = new double[3];
    public final double[] maxDirection = new double[3];

    /** What is farther away, in that unit, does not matter. */
    public double maxDistance;

    private void clear() {
        for (int axis = 0; axis < 3; axis++) {
            minOrigin[axis] = minDirection[axis] = Double.POSITIVE_INFINITY;
            maxOrigin[axis] = maxDirection[axis] = Double.NEGATIVE_INFINITY;
        }
        maxDistance = 0;
    }

    /** Takes in a batch's rays, from one index to another, in place of all others, as far as their distances. */
    public void enclose(Rays rays, int from, int to) {
        clear();
        if (rays.leaveEye && rays.axes != null) {
            System.arraycopy(rays.minEyeDirection, 0, minDirection, 0, 3);
            System.arraycopy(rays.maxEyeDirection, 0, maxDirection, 0, 3);
        } else {
            include(rays.direction, from, to, minDirection, maxDirection);
        }
        include(rays.origin, from, rays.leaveEye ? from + 1 : to, minOrigin, maxOrigin);
        for (int i = from; i < to && maxDistance < Double.POSITIVE_INFINITY; i++) {
            maxDistance = rays.distance[i] > maxDistance ? rays.distance[i] : maxDistance;
        }
    }

    /**
     * Takes in the ways from where rays have arrived to a light, in place of all others. From a light at a point they
     * are taken backwards, as what starts at a point is narrower; distances are then in parts of the way.
     */
    public void enclose(Rays rays, LightSource light, int from, int to) {
        clear();
        include(rays.origin, from, to, minOrigin, maxOrigin);
        double[] position = {light.x(), light.y(), light.z()};
        for (int axis = 0; axis < 3; axis++) {
            if (light.directional()) {
                minDirection[axis] = maxDirection[axis] = position[axis];
            } else {
                minDirection[axis] = minOrigin[axis] - position[axis];
                maxDirection[axis] = maxOrigin[axis] - position[axis];
                minOrigin[axis] = maxOrigin[axis] = position[axis];
            }
        }
        maxDistance = light.directional() ? Double.POSITIVE_INFINITY : 1;
    }

    private static void include(Vectors vectors, int from, int to, double[] min, double[] max) {
        include(vectors.x(), from, to, min, max, 0);
        include(vectors.y(), from, to, min, max, 1);
        include(vectors.z(), from, to, min, max, 2);
    }

    /**
     * In whole numbers that are in the same order as doubles, for which the processor needs no branch: comparisons of doubles
     * are branches, and mispredicted where coordinates go up and down by the row. With a NaN among the values an end of the
     * interval is one, by which no comparison rules anything out.
     */
    private static void include(double[] values, int from, int to, double[] min, double[] max, int axis) {
        long low = Long.MAX_VALUE, high = Long.MIN_VALUE;
        for (int i = from; i < to; i++) {
            long v = ordered(Double.doubleToRawLongBits(values[i]));
            low = Math.min(low, v);
            high = Math.max(high, v);
        }
        min[axis] = Math.min(min[axis], Double.longBitsToDouble(ordered(low)));
        max[axis] = Math.max(max[axis], Double.longBitsToDouble(ordered(high)));
    }

    /** From a double's bits to a number in the order of doubles, and back. */
    private static long ordered(long bits) {
        return bits ^ bits >> 63 >>> 1;
    }
}
