package raytracer.tracer.lightbuffer;

import java.util.Arrays;
import raytracer.tracer.bvh.Bvh;

/**
 * How a primitive is seen on a {@link CubeFace}: a triangle, or a box around something round. Serves primitive after
 * primitive.
 */
public final class ProjectedOutline {

    // The triangle, as seen from the source.
    private double ax, ay, az;
    private double bx, by, bz;
    private double cx, cy, cz;
    private double radius;

    private double nearest;

    // Where the corners are seen.
    private double ua, va;
    private double ub, vb;
    private double uc, vc;

    // The box around what is seen.
    private double minU, maxU;
    private double minV, maxV;

    // By edge: e u + f v + g is negative outside.
    private double e0, f0, g0;
    private double e1, f1, g1;
    private double e2, f2, g2;

    private int[] cells = new int[64];

    /** Sets a corner, which is in the tree's space and as seen from the source. */
    void setCorner(int corner, double x, double y, double z) {
        if (corner == 0) {
            ax = x;
            ay = y;
            az = z;
        } else if (corner == 1) {
            bx = x;
            by = y;
            bz = z;
        } else {
            cx = x;
            cy = y;
            cz = z;
        }
    }

    /** Sets how far the outline is from the triangle, in the tree's space but for the boxes' padding. */
    void setRadius(double radius) {
        this.radius = radius + Bvh.PADDING;
    }

    /** The number of the only face on which it is seen; negative if there may be more. */
    int onlyFace() {
        int face = CubeFace.number(ax, ay, az);
        int axis = face / 2;
        double sign = face % 2 == 0 ? 1 : -1;
        double room = axis == 0 ? min(room(sign * ax, ay, az), room(sign * bx, by, bz), room(sign * cx, cy, cz))
                : axis == 1 ? min(room(sign * ay, az, ax), room(sign * by, bz, bx), room(sign * cy, cz, cx))
                : min(room(sign * az, ax, ay), room(sign * bz, bx, by), room(sign * cz, cx, cy));
        return room > 2 * radius ? face : -1;
    }

    /** By how much a point's depth is more than it is across. */
    private static double room(double depth, double across, double down) {
        return depth - Math.max(Math.abs(across), Math.abs(down));
    }

    /** Looks at it on a face; false if it is not seen in the part with cells. */
    boolean isSeenOn(CubeFace face) {
        double depthA = face.depth(ax, ay, az), depthB = face.depth(bx, by, bz), depthC = face.depth(cx, cy, cz);
        ua = face.across(ax, ay, az);
        va = face.down(ax, ay, az);
        ub = face.across(bx, by, bz);
        vb = face.down(bx, by, bz);
        uc = face.across(cx, cy, cz);
        vc = face.down(cx, cy, cz);
        nearest = min(depthA, depthB, depthC) - radius;
        if (face.isParallel()) {
            span(radius * face.spreadU(), radius * face.spreadV());
            return true;
        }
        if (max(depthA, depthB, depthC) + radius < 0) {
            return false;
        }
        if (nearest <= radius) {
            if (isBeside(ua, ub, uc, depthA, depthB, depthC) || isBeside(va, vb, vc, depthA, depthB, depthC)) {
                return false;
            }
            // Around the source, or nearly: it may be anywhere.
            ua = va = ub = vb = uc = vc = 0;
            span(1, 1);
        } else {
            ua /= depthA;
            va /= depthA;
            ub /= depthB;
            vb /= depthB;
            uc /= depthC;
            vc /= depthC;
            // Tangents to a circle of radius r about (w, u w) cross depth 1 no farther from u than
            // r sqrt(1 + u^2) / (w - r).
            double perRoot = radius / nearest;
            span(perRoot * root(ua, ub, uc), perRoot * root(va, vb, vc));
        }
        return face.overlaps(minU, maxU, minV, maxV);
    }

    /** Whether all of it is outside of one of two sides of the pyramid below the face, which stand at 45 degrees. */
    private boolean isBeside(double a, double b, double c, double depthA, double depthB, double depthC) {
        double beyond = Math.max(min(a - depthA, b - depthB, c - depthC),
                min(-a - depthA, -b - depthB, -c - depthC));
        return beyond > 1.5 * radius;
    }

    /** The root of 1 + the greatest square. */
    private static double root(double a, double b, double c) {
        double max = max(Math.abs(a), Math.abs(b), Math.abs(c));
        return Math.sqrt(1 + max * max);
    }

    private static double min(double a, double b, double c) {
        return Math.min(a, Math.min(b, c));
    }

    private static double max(double a, double b, double c) {
        return Math.max(a, Math.max(b, c));
    }

    /** Sets the box and the edges around the corners and all that is so far from them. */
    private void span(double marginU, double marginV) {
        minU = min(ua, ub, uc) - marginU;
        maxU = max(ua, ub, uc) + marginU;
        minV = min(va, vb, vc) - marginV;
        maxV = max(va, vb, vc) + marginV;
        double turn = (ub - ua) * (vc - va) - (uc - ua) * (vb - va) > 0 ? 1 : -1;
        e0 = turn * (va - vb);
        f0 = turn * (ub - ua);
        g0 = margin(e0, f0, marginU, marginV) - (e0 * ua + f0 * va);
        e1 = turn * (vb - vc);
        f1 = turn * (uc - ub);
        g1 = margin(e1, f1, marginU, marginV) - (e1 * ub + f1 * vb);
        e2 = turn * (vc - va);
        f2 = turn * (ua - uc);
        g2 = margin(e2, f2, marginU, marginV) - (e2 * uc + f2 * vc);
    }

    /** How much more an edge has inside if it is moved out by so much along both axes. */
    private static double margin(double e, double f, double u, double v) {
        return Math.abs(e) * u + Math.abs(f) * v;
    }

    /** No depth of its points is less. */
    double nearest() {
        return nearest;
    }

    /** How many cells there are in the box around it. */
    long cellsAround(CubeFace face) {
        return (face.column(maxU) - face.column(minU) + 1L) * (face.row(maxV) - face.row(minV) + 1);
    }

    /** Finds the {@link #cell}s in which it is seen, those that no edge has all outside; returns how many. */
    int findCells(CubeFace face) {
        int firstColumn = face.column(minU), lastColumn = face.column(maxU);
        int firstRow = face.row(minV), lastRow = face.row(maxV);
        if (cells.length < cellsAround(face)) {
            cells = Arrays.copyOf(cells, (int) (2 * cellsAround(face)));
        }
        // From the corner of a cell that is farthest inside an edge to the middle.
        double half = face.side() / 2;
        double out0 = g0 + margin(e0, f0, half, half), out1 = g1 + margin(e1, f1, half, half);
        double out2 = g2 + margin(e2, f2, half, half);
        int found = 0;
        for (int row = firstRow; row <= lastRow; row++) {
            double v = face.v(row);
            double row0 = f0 * v + out0, row1 = f1 * v + out1, row2 = f2 * v + out2;
            for (int column = firstColumn; column <= lastColumn; column++) {
                double u = face.u(column);
                cells[found] = face.cell(column, row);
                found += min(e0 * u + row0, e1 * u + row1, e2 * u + row2) >= 0 ? 1 : 0;
            }
        }
        return found;
    }

    /** Number n of the cells that were found last. */
    int cell(int n) {
        return cells[n];
    }
}
