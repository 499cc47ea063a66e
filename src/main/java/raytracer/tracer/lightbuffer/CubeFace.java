package raytracer.tracer.lightbuffer;

/**
 * A face of the cube of directions around a source, divided into cells. What the source sees is at (u, v): the other
 * two of its coordinates by its depth, which is the coordinate along the face's axis. A directional light has one
 * face, whose places stand for parallels.
 */
public final class CubeFace {

    /** Which coordinate is the depth; u and v are of the next and of the one after. */
    private final int axis;
    private final int axisU;
    private final int axisV;

    /** 1 if depths grow with the coordinate, -1 if they fall. */
    private final double sign;

    private final boolean parallel;

    /** How far u and v move along a parallel by the coordinate of the axis. */
    private final double slopeU;
    private final double slopeV;

    // The part that is divided into cells, and where these are among all faces' cells.
    private double minU = Double.POSITIVE_INFINITY;
    private double minV = Double.POSITIVE_INFINITY;
    private double maxU = Double.NEGATIVE_INFINITY;
    private double maxV = Double.NEGATIVE_INFINITY;
    private double side;
    private double cellsPerUnit;
    private int columns;
    private int rows;
    private int firstCell;

    private CubeFace(int axis, double sign, boolean parallel, double slopeU, double slopeV) {
        this.axis = axis;
        axisU = (axis + 1) % 3;
        axisV = (axis + 2) % 3;
        this.sign = sign;
        this.parallel = parallel;
        this.slopeU = slopeU;
        this.slopeV = slopeV;
    }

    /** The faces around a source, in the order of {@link #number}. */
    static CubeFace[] around() {
        CubeFace[] faces = new CubeFace[6];
        for (int number = 0; number < 6; number++) {
            faces[number] = new CubeFace(number / 2, number % 2 == 0 ? 1 : -1, false, 0, 0);
        }
        return faces;
    }

    /** The face of a directional light, by the direction towards it: depths fall that way. */
    static CubeFace of(double dx, double dy, double dz) {
        double[] d = {dx, dy, dz};
        int axis = number(dx, dy, dz) / 2;
        return new CubeFace(axis, -Math.signum(d[axis]), true, d[(axis + 1) % 3] / d[axis], d[(axis + 2) % 3] / d[axis]);
    }

    /** On which face around the origin a point is seen: twice its axis, and 1 more on the negative side. */
    static int number(double x, double y, double z) {
        double ax = Math.abs(x), ay = Math.abs(y), az = Math.abs(z);
        return ax >= ay && ax >= az ? x > 0 ? 0 : 1 : ay >= az ? y > 0 ? 2 : 3 : z > 0 ? 4 : 5;
    }

    boolean isParallel() {
        return parallel;
    }

    private double along(double x, double y, double z) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    // Of a point as seen from the source: its depth, and u and v but for the division by the depth.

    double depth(double x, double y, double z) {
        return sign * along(x, y, z);
    }

    double across(double x, double y, double z) {
        return along(y, z, x) - slopeU * along(x, y, z);
    }

    double down(double x, double y, double z) {
        return along(z, x, y) - slopeV * along(x, y, z);
    }

    /** How far u moves, at most, with a point that moves by 1. */
    double spreadU() {
        return Math.sqrt(1 + slopeU * slopeU);
    }

    /** How far v moves, at most, with a point that moves by 1. */
    double spreadV() {
        return Math.sqrt(1 + slopeV * slopeV);
    }

    /** Makes the part with cells larger, so that it holds all that is seen of a box, as seen from the source. */
    void include(double[] min, double[] max) {
        if (parallel) {
            double u0 = slopeU * min[axis], u1 = slopeU * max[axis];
            double v0 = slopeV * min[axis], v1 = slopeV * max[axis];
            include(min[axisU] - Math.max(u0, u1), max[axisU] - Math.min(u0, u1),
                    min[axisV] - Math.max(v0, v1), max[axisV] - Math.min(v0, v1));
            return;
        }
        double near = sign > 0 ? min[axis] : -max[axis], far = sign > 0 ? max[axis] : -min[axis];
        if (far > 0) {
            include(Math.max(-1, -max(-min[axisU], near, far)), Math.min(1, max(max[axisU], near, far)),
                    Math.max(-1, -max(-min[axisV], near, far)), Math.min(1, max(max[axisV], near, far)));
        }
    }

    /** How far on the face something is seen, at most, that is so far across or down, between two depths. */
    private static double max(double across, double near, double far) {
        return across <= 0 ? across / far : near > 0 ? across / near : Double.POSITIVE_INFINITY;
    }

    private void include(double fromU, double toU, double fromV, double toV) {
        if (fromU <= toU && fromV <= toV) {
            minU = Math.min(minU, fromU);
            minV = Math.min(minV, fromV);
            maxU = Math.max(maxU, toU);
            maxV = Math.max(maxV, toV);
        }
    }

    /** Whether the part with cells has anything in common with a box. */
    boolean overlaps(double fromU, double toU, double fromV, double toV) {
        return fromU <= maxU && toU >= minU && fromV <= maxV && toV >= minV;
    }

    /** Of the part that is to have cells. */
    double area() {
        return minU < maxU ? (maxU - minU) * (maxV - minV) : 0;
    }

    /** Divides it into cells of this side; returns how many. */
    int divide(double sideOfCells, int numberOfFirst) {
        if (!(minU < maxU)) {
            return 0;
        }
        side = sideOfCells;
        cellsPerUnit = 1 / side;
        columns = 1 + (int) ((maxU - minU) * cellsPerUnit);
        rows = 1 + (int) ((maxV - minV) * cellsPerUnit);
        firstCell = numberOfFirst;
        return Math.multiplyExact(columns, rows);
    }

    int column(double u) {
        return Math.max(0, Math.min(columns - 1, (int) ((u - minU) * cellsPerUnit)));
    }

    int row(double v) {
        return Math.max(0, Math.min(rows - 1, (int) ((v - minV) * cellsPerUnit)));
    }

    /** Of a cell. */
    double side() {
        return side;
    }

    /** The middle of a column. */
    double u(int column) {
        return minU + (column + .5) * side;
    }

    /** The middle of a row. */
    double v(int row) {
        return minV + (row + .5) * side;
    }

    int cell(int column, int row) {
        return firstCell + row * columns + column;
    }

    /** The cell in which a point is seen; negative if it is seen in none. */
    int cell(double x, double y, double z) {
        double u = across(x, y, z), v = down(x, y, z);
        if (!parallel) {
            double reciprocal = 1 / depth(x, y, z);
            u *= reciprocal;
            v *= reciprocal;
        }
        double column = (u - minU) * cellsPerUnit, row = (v - minV) * cellsPerUnit;
        return column >= 0 && column < columns && row >= 0 && row < rows ? cell((int) column, (int) row) : -1;
    }
}
