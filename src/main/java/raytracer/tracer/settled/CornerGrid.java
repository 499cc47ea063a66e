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

    /** All cells between two columns and two rows of corners. */
    record Cells(int left, int top, int right, int bottom) {

        boolean isOne() {
            return right - left == 1 && bottom - top == 1;
        }

        int cornerCount() {
            return (right - left + 1) * (bottom - top + 1);
        }

        private Cells half(boolean isFirst) {
            int column = (left + right) >>> 1, row = (top + bottom) >>> 1;
            return right - left > bottom - top
                    ? isFirst ? new Cells(left, top, column, bottom) : new Cells(column, top, right, bottom)
                    : isFirst ? new Cells(left, top, right, row) : new Cells(left, row, right, bottom);
        }
    }

    /** What is to be proved of cells. */
    interface Claim {
        boolean holds(Cells cells);
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
        prove(claim, new Cells(0, 0, columns - 1, rows - 1));
    }

    private void prove(Claim claim, Cells cells) {
        if (!isAnySettled(cells) || claim.holds(cells)) {
            return;
        }
        if (cells.isOne()) {
            settled[cells.top * (columns - 1) + cells.left] = false;
        } else {
            prove(claim, cells.half(true));
            prove(claim, cells.half(false));
        }
    }

    private boolean isAnySettled(Cells cells) {
        for (int row = cells.top; row < cells.bottom; row++) {
            for (int column = cells.left; column < cells.right; column++) {
                if (settled[row * (columns - 1) + column]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The corner in a column and a row. */
    int corner(int column, int row) {
        return row * columns + column;
    }

    /** The four outermost corners, in their order around the cells. */
    int[] outermost(Cells c) {
        return new int[] {
            corner(c.left, c.top), corner(c.right, c.top), corner(c.right, c.bottom), corner(c.left, c.bottom)};
    }

    /** The four corners of one cell. */
    int[] cornersOf(int cell) {
        int column = cell % (columns - 1), row = cell / (columns - 1);
        return outermost(new Cells(column, row, column + 1, row + 1));
    }

    /** How many corners of cells have a ray. */
    int rayCount(Cells cells) {
        int count = 0;
        for (int row = cells.top; row <= cells.bottom; row++) {
            for (int p = corner(cells.left, row); p <= corner(cells.right, row); p++) {
                count += rayOf[p] >= 0 ? 1 : 0;
            }
        }
        return count;
    }
}
