package raytracer.chart;

import java.util.ArrayList;
import java.util.List;

/** Finds places for texts where they cover nothing: as near to what they name as there is room. */
final class Labels {

    /** A rectangle, in pixels from the left and from the top. */
    record Box(double left, double top, double right, double bottom) {

        /** Around a text of this many characters, whose line is here. */
        static Box of(double left, double baseline, int characters, double fontSize) {
            return new Box(left, baseline - .8 * fontSize, left + WIDTH * fontSize * characters,
                    baseline + .25 * fontSize);
        }

        boolean isClearOf(Box other) {
            return right <= other.left || left >= other.right || bottom <= other.top || top >= other.bottom;
        }

        boolean isIn(Box other) {
            return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
        }
    }

    /** Of bold characters, for each pixel of the font's size: a little more than most fonts have. */
    static final double WIDTH = .63;

    /** From a dot's middle to a text beside it. */
    private static final double BESIDE = 8;

    private static final double FONT_SIZE = 11;

    /** From one distance that is tried to the next, and how many are. */
    private static final double STEP = 13;
    private static final int STEPS = 12;

    private final Box area;
    private final List<Box> taken = new ArrayList<>();

    Labels(Box area) {
        this.area = area;
    }

    /** Keeps texts from here. */
    void take(Box box) {
        taken.add(box);
    }

    /** Keeps others from here, if nothing is here yet; returns whether that is so. */
    boolean takeIfFree(Box box) {
        boolean isFree = box.isIn(area) && taken.stream().allMatch(box::isClearOf);
        if (isFree) {
            take(box);
        }
        return isFree;
    }

    /** A place for a text that names a dot; beside it, if no place is free. */
    Box place(double x, double y, int characters) {
        double width = WIDTH * FONT_SIZE * characters;
        for (int step = 0; step <= STEPS; step++) {
            double up = step * STEP;
            double[][] corners = {
                {x + BESIDE, y + 4 - up}, {x - BESIDE - width, y + 4 - up}, {x - width / 2, y - 9 - up},
                {x + BESIDE, y + 4 + up}, {x - BESIDE - width, y + 4 + up}, {x - width / 2, y + 17 + up},
                {x + BESIDE + up, y + 4}, {x - BESIDE - width - up, y + 4}};
            for (double[] corner : corners) {
                Box box = Box.of(corner[0], corner[1], characters, FONT_SIZE);
                if (takeIfFree(box)) {
                    return box;
                }
            }
        }
        return Box.of(x + BESIDE, y + 4, characters, FONT_SIZE);
    }
}
