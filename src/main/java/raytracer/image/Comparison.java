package raytracer.image;

import java.awt.image.BufferedImage;

/**
 * How two pictures of one size differ.
 *
 * @param pixels     how many pixels differ in any component
 * @param beyond     how many differ by more than the tolerance
 * @param max        the greatest difference of a component, of 255, at the pixel {@code (x, y)}
 * @param rmse       the root of the mean square of all components' differences, of 255
 * @param left       the box around the pixels that differ: {@code left <= x <= right}, {@code top <= y <= bottom}
 * @param difference where they differ beyond the tolerance
 */
public record Comparison(long pixels, long beyond, int max, int x, int y, double rmse,
        int left, int top, int right, int bottom, BufferedImage difference) {

    /** Around each pixel beyond the tolerance, so that a single one is found. */
    private static final int HALO = 0x703000;

    /**
     * Compares pictures of the same size.
     *
     * @param tolerance what a component may differ by, of 255
     */
    public static Comparison of(BufferedImage actual, BufferedImage expected, int tolerance) {
        int w = actual.getWidth(), h = actual.getHeight();
        BufferedImage difference = new BufferedImage(w, h, BufferedImage.TYPE_INT_RGB);
        long pixels = 0, beyond = 0, squares = 0;
        int max = 0, maxX = 0, maxY = 0, left = w, top = h, right = -1, bottom = -1;
        for (int y = 0; y < h; y++) {
            for (int x = 0; x < w; x++) {
                int a = actual.getRGB(x, y), b = expected.getRGB(x, y);
                int red = distance(a >> 16, b >> 16), green = distance(a >> 8, b >> 8), blue = distance(a, b);
                int most = Math.max(red, Math.max(green, blue));
                squares += red * red + green * green + blue * blue;
                if (difference.getRGB(x, y) << 8 == 0) {
                    difference.setRGB(x, y, dimmed(a));
                }
                if (most > tolerance) {
                    beyond++;
                    mark(difference, x, y, most);
                }
                if (most > max) {
                    max = most;
                    maxX = x;
                    maxY = y;
                }
                if (most > 0) {
                    pixels++;
                    left = Math.min(left, x);
                    right = Math.max(right, x);
                    top = Math.min(top, y);
                    bottom = y;
                }
            }
        }
        return new Comparison(pixels, beyond, max, maxX, maxY, Math.sqrt(squares / (3.0 * w * h)),
                left, top, right, bottom, difference);
    }

    private static int distance(int a, int b) {
        return Math.abs((a & 255) - (b & 255));
    }

    /** Grey, and dark: no colour of it is one of a mark. */
    private static int dimmed(int rgb) {
        return ((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 12 * 0x010101;
    }

    private static void mark(BufferedImage difference, int column, int row, int most) {
        for (int y = Math.max(0, row - 1); y <= Math.min(difference.getHeight() - 1, row + 1); y++) {
            for (int x = Math.max(0, column - 1); x <= Math.min(difference.getWidth() - 1, column + 1); x++) {
                if (!isMark(difference.getRGB(x, y))) {
                    difference.setRGB(x, y, HALO);
                }
            }
        }
        difference.setRGB(column, row, shown(most));
    }

    private static boolean isMark(int rgb) {
        return (rgb >> 16 & 255) == 255;
    }

    /** From orange for a step of 256 to white. */
    private static int shown(int steps) {
        int v = Math.min(255, 8 * steps);
        return 255 << 16 | 128 + v / 2 << 8 | v;
    }
}
