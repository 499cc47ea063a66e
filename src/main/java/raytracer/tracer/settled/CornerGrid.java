package raytracer.tracer.settled;

import java.util.Arrays;
import raytracer.tracer.arithmetic.Batch;

/** Corners of pixels in columns and rows, and the cells between them, each a pixel. */
final class CornerGrid {

    final int columns;
    final int rows;

    /** By cell, row by row: whether all claims so far hold of it. */
    final boolean[] settled;

    /** By corner, row by row: the index of its ray among those that a claim is about; negative if it has none. */
    final int[] rayOf = new int[Batch.CAPACITY];

    /** What is to be proved of all cells between two columns and two rows of corners. */
    interface Claim {
        boolean holds(int left, int top, int right, int bottom);
    }

    CornerGrid(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        settled = new boolean[(columns - 1) * (rows - 1)];
        Arrays.fill(settled, true);
    }

    /**
     * Tries to prove a claim of all cells. What holds of a rectangle holds of each cell in it; where it does not, the
     * rectangle's halves are tried, down to single cells.
     */
    void prove(Claim claim) {
        prove(claim, 0, 0, columns - 1, rows - 1);
    }

    private void prove(Claim claim, int left, int top, int right, int bottom) {
        if (!isAnySettled(left, top, right, bottom) || claim.holds(left, top, right, bottom)) {
            return;
        }
        if (isCell(left, top, right, bottom)) {
            settled[top * (columns - 1) + left] = false;
        } else if (right - left > bottom - top) {
            int middle = (left + right) >>> 1;
            prove(claim, left, top, middle, bottom);
            prove(claim, middle, top, right, bottom);
        } else {
            int middle = (top + bottom) >>> 1;
            prove(claim, left, top, right, middle);
            prove(claim, left, middle, right, bottom);
        }
    }

    static boolean isCell(int left, int top, int right, int bottom) {
        return right - left == 1 && bottom - top == 1;
    }

    private boolean isAnySettled(int left, int top, int right, int bottom) {
        for (int row = top; row < bottom; row++) {
            for (int column = left; column < right; column++) {
                if (settled[row * (columns - 1) + column]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The corner of the grid at one of a rectangle's four, in their order around it. */
    int corner(int corner, int left, int top, int right, int bottom) {
        return (corner < 2 ? top : bottom) * columns + (corner == 0 || corner == 3 ? left : right);
    }

    /** How many corners in a rectangle have a ray. */
    int count(int left, int top, int right, int bottom) {
        int count = 0;
        for (int row = top; row <= bottom; row++) {
            for (int p = row * columns + left; p <= row * columns + right; p++) {
                count += rayOf[p] >= 0 ? 1 : 0;
            }
        }
        return count;
    }

    /** The upper left corner of a cell. */
    int point(int cell) {
        return cell / (columns - 1) * columns + cell % (columns - 1);
    }
}
