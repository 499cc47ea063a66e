package raytracer.render;

/**
 * A rectangle of a picture's pixels.
 *
 * @param x      its first column, from 0; {@code y} its first row
 * @param width  at least 1, and so is {@code height}
 */
public record Region(int x, int y, int width, int height) {

    /** All of a picture. */
    public static Region whole(int width, int height) {
        return new Region(0, 0, width, height);
    }

    int pixels() {
        return width * height;
    }

    /** The column of pixel i, row by row. */
    int column(int i) {
        return x + i % width;
    }

    int row(int i) {
        return y + i / width;
    }
}
