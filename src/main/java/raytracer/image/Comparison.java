package raytracer.image;

import java.awt.image.BufferedImage;

/**
 * How two pictures of one size differ.
 *
 * @param pixels     how many pixels differ in any component
 * @param beyond     how many differ by more than the tolerance
 * @param greatest   the greatest difference of a component, of 255, at the pixel {@code (x, y)}
 * @param rmse       the root of the mean square of all components' differences, of 255
 * @param left       the box around the pixels that differ: {@code left <= x <= right}, {@code top <= y <= bottom}
 * @param difference where they are alike, the picture, dimmed; where not, the difference, amplified
 */
public record Comparison(long pixels, long beyond, int greatest, int x, int y, double rmse,
        int left, int top, int right, int bottom, BufferedImage difference) {

    /** Of what they are: the parts where pictures are alike. */
    private static final int DIM = 4;

    /** The least brightness of a pixel that differs, and by how much more each step of difference is seen. */
    private static final int LEAST = 96;
    private static final int AMPLIFIED = 16;

    /**
     * Compares pictures of the same size.
     *
     * @param tolerance what a component may differ by, of 255
     */
    public static Comparison of(BufferedImage actual, BufferedImage expected, int tolerance) {
        int w = actual.getWidth(), h = actual.getHeight();
        BufferedImage difference = new BufferedImage(w, h, BufferedImage.TYPE_INT_RGB);
        long pixels = 0, beyond = 0, squares = 0;
        int greatest = 0, x = 0, y = 0, left = w, top = h, right = -1, bottom = -1;
        for (int row = 0; row < h; row++) {
            for (int column = 0; column < w; column++) {
                int a = actual.getRGB(column, row), b = expected.getRGB(column, row);
                int red = distance(a >> 16, b >> 16), green = distance(a >> 8, b >> 8), blue = distance(a, b);
                int most = Math.max(red, Math.max(green, blue));
                squares += red * red + green * green + blue * blue;
                if (most == 0) {
                    difference.setRGB(column, row, dimmed(a));
                    continue;
                }
                difference.setRGB(column, row, seen(red) << 16 | seen(green) << 8 | seen(blue));
                pixels++;
                beyond += most > tolerance ? 1 : 0;
                if (most > greatest) {
                    greatest = most;
                    x = column;
                    y = row;
                }
                left = Math.min(left, column);
                right = Math.max(right, column);
                top = Math.min(top, row);
                bottom = row;
            }
        }
        return new Comparison(pixels, beyond, greatest, x, y, Math.sqrt(squares / (3.0 * w * h)),
                left, top, right, bottom, difference);
    }

    private static int distance(int a, int b) {
        return Math.abs((a & 255) - (b & 255));
    }

    private static int seen(int step) {
        return step == 0 ? 0 : Math.min(255, LEAST + AMPLIFIED * step);
    }

    private static int dimmed(int rgb) {
        return (rgb >> 16 & 255) / DIM << 16 | (rgb >> 8 & 255) / DIM << 8 | (rgb & 255) / DIM;
    }
}
