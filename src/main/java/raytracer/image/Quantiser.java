package raytracer.image;

import java.util.concurrent.atomic.LongAdder;

/**
 * The one place where linear colour becomes bytes: red, green and blue in turns, in rows of a width. Threads may set
 * different pixels at the same time.
 */
final class Quantiser {

    private static final int COMPONENTS = 3;

    private final int width;
    private final LongAdder undefined = new LongAdder();
    /** Whether any byte is not 0: threads only ever set it. */
    private boolean lit;

    Quantiser(int width) {
        this.width = width;
    }

    /** How many pixels were set that are no number. */
    long undefinedPixels() {
        return undefined.sum();
    }

    /** Whether all bytes that were set are 0; to be asked when the threads that set them have ended. */
    boolean isBlack() {
        return !lit;
    }

    /** Sets the pixels of a rectangle, given row by row; what is no number becomes 0 and is counted. */
    void set(byte[] bytes, int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
        int notNumbers = 0;
        for (int row = 0; row < rows; row++) {
            int to = COMPONENTS * ((y + row) * width + x);
            notNumbers += setRow(bytes, to, row * columns, columns, red, green, blue);
        }
        if (notNumbers > 0) {
            undefined.add(notNumbers);
        }
    }

    /** Returns how many of the row's pixels are no number. */
    private int setRow(
            byte[] bytes, int to, int from, int count, double[] red, double[] green, double[] blue) {
        int notNumbers = 0;
        int all = 0;
        int at = to;
        for (int i = from; i < from + count; i++) {
            bytes[at] = toByte(red[i]);
            bytes[at + 1] = toByte(green[i]);
            bytes[at + 2] = toByte(blue[i]);
            all |= bytes[at] | bytes[at + 1] | bytes[at + 2];
            at += COMPONENTS;
            notNumbers += Double.isNaN(red[i] + green[i] + blue[i]) ? 1 : 0;
        }
        if (all != 0) {
            lit = true;
        }
        return notNumbers;
    }

    /**
     * A component, cut to [0, 1], as {@link java.awt.Color#Color(float, float, float)} makes it a byte: the product is
     * one of floats. So decimals such as .3, half a step but for their own last bit, become what their author means.
     */
    private static byte toByte(double c) {
        float product = (float) Math.min(1, Math.max(0, c)) * 255;
        return (byte) (int) (product + 0.5);
    }
}
