package raytracer.tracer;

/** How a thing is seen on a {@link Face}: a triangle, or a box around something round. Serves thing after thing. */
final class Outline {

    /** As seen from the lamp. */
    private final double[] hull = new double[Hulls.SIZE];

    // By corner.
    private final double[] depth = new double[3];
    private final double[] u = new double[3];
    private final double[] v = new double[3];

    private double nearest;
    private double leastU;
    private double greatestU;
    private double leastV;
    private double greatestV;

    // By edge: a u + b v + c is negative outside.
    private final double[] a = new double[3];
    private final double[] b = new double[3];
    private final double[] c = new double[3];

    /** What is to be seen. */
    double[] hull() {
        return hull;
    }

    /** The number of the only face on which it is seen; negative if there may be more. */
    int onlyFace() {
        int face = Face.number(hull[0], hull[1], hull[2]);
        int axis = face / 2, axisU = axis == 2 ? 0 : axis + 1, axisV = axis == 0 ? 2 : axis - 1;
        double room = Double.POSITIVE_INFINITY;
        for (int corner = 0; corner < Hulls.RADIUS; corner += 3) {
            double along = face % 2 == 0 ? hull[corner + axis] : -hull[corner + axis];
            room = Math.min(room,
                    along - Math.max(Math.abs(hull[corner + axisU]), Math.abs(hull[corner + axisV])));
        }
        return room > 2 * hull[Hulls.RADIUS] ? face : -1;
    }

    /** Looks at it on a face; false if it is not seen there. */
    boolean isSeenOn(Face face) {
        double radius = hull[Hulls.RADIUS];
        for (int corner = 0; corner < 3; corner++) {
            double x = hull[3 * corner], y = hull[3 * corner + 1], z = hull[3 * corner + 2];
            depth[corner] = face.depth(x, y, z);
            u[corner] = face.across(x, y, z);
            v[corner] = face.down(x, y, z);
        }
        nearest = least(depth) - radius;
        if (face.isParallel()) {
            span(radius * face.spreadU(), radius * face.spreadV());
            return true;
        }
        if (greatest(depth) + radius < 0 || isOutside(u, radius) || isOutside(v, radius)) {
            return false;
        }
        if (nearest <= radius) {
            // Around the lamp, or nearly: it may be anywhere.
            span(0, 0);
            leastU = leastV = -1;
            greatestU = greatestV = 1;
            for (int edge = 0; edge < 3; edge++) {
                a[edge] = 0;
            }
            return true;
        }
        for (int corner = 0; corner < 3; corner++) {
            u[corner] /= depth[corner];
            v[corner] /= depth[corner];
        }
        // Tangents to a circle of radius r about (w, u w) meet depth 1 no farther from u than
        // r sqrt(1 + u^2) / (w - r).
        double perRoot = radius / nearest;
        span(perRoot * root(u), perRoot * root(v));
        leastU = Math.max(-1, leastU);
        leastV = Math.max(-1, leastV);
        greatestU = Math.min(1, greatestU);
        greatestV = Math.min(1, greatestV);
        return leastU <= greatestU && leastV <= greatestV;
    }

    /** Whether all of it is outside of one of two sides of the pyramid below the face, which stand at 45 degrees. */
    private boolean isOutside(double[] across, double radius) {
        double above = Math.min(across[0] - depth[0], Math.min(across[1] - depth[1], across[2] - depth[2]));
        double below = Math.min(-across[0] - depth[0], Math.min(-across[1] - depth[1], -across[2] - depth[2]));
        return Math.max(above, below) > 1.5 * radius;
    }

    /** The root of 1 + the greatest square. */
    private static double root(double[] across) {
        double most = Math.max(greatest(across), -least(across));
        return Math.sqrt(1 + most * most);
    }

    private static double least(double[] three) {
        return Math.min(three[0], Math.min(three[1], three[2]));
    }

    private static double greatest(double[] three) {
        return Math.max(three[0], Math.max(three[1], three[2]));
    }

    /** Sets the box and the edges around the corners and all that is so far from them. */
    private void span(double marginU, double marginV) {
        leastU = least(u) - marginU;
        greatestU = greatest(u) + marginU;
        leastV = least(v) - marginV;
        greatestV = greatest(v) + marginV;
        double turn = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]) > 0 ? 1 : -1;
        for (int edge = 0; edge < 3; edge++) {
            int next = edge == 2 ? 0 : edge + 1;
            a[edge] = turn * (v[edge] - v[next]);
            b[edge] = turn * (u[next] - u[edge]);
            c[edge] = Math.abs(a[edge]) * marginU + Math.abs(b[edge]) * marginV
                    - (a[edge] * u[edge] + b[edge] * v[edge]);
        }
    }

    /** No depth of its points is less. */
    double nearest() {
        return nearest;
    }

    double leastU() {
        return leastU;
    }

    double greatestU() {
        return greatestU;
    }

    double leastV() {
        return leastV;
    }

    double greatestV() {
        return greatestV;
    }

    // In which cells it is seen: rows, and in each of them columns.

    int firstRow(Face face) {
        return face.row(leastV);
    }

    int lastRow(Face face) {
        return face.row(greatestV);
    }

    int firstColumn(Face face, int row) {
        double first = leastU;
        for (int edge = 0; edge < 3; edge++) {
            if (a[edge] > 0) {
                first = Math.max(first, end(edge, face, row));
            }
        }
        return face.column(first);
    }

    /** Before the first if there is none. */
    int lastColumn(Face face, int row) {
        double last = greatestU;
        for (int edge = 0; edge < 3; edge++) {
            if (a[edge] < 0) {
                last = Math.min(last, end(edge, face, row));
            }
        }
        return face.column(last);
    }

    /** The u as far as which the inside of an edge reaches within a row. */
    private double end(int edge, Face face, int row) {
        return (c[edge] + b[edge] * (b[edge] > 0 ? face.v(row + 1) : face.v(row))) / -a[edge];
    }
}
