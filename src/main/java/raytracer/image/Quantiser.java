package raytracer.image;

import java.util.concurrent.atomic.LongAdder;

/**
 * The one place where linear colour becomes bytes: red, green and blue in turns, in rows of a width. Threads may set
 * different pixels at the same time.
 */
final class Quantiser {

    private static final int COMPONENTS = 3;

    /** From here on doubles are whole numbers, which are in their last bits. */
    private static final double WHOLE = 0x1p52;

    /** The sign and exponent of all steps; those of NaN have more bits set. */
    private static final long EXPONENT = Double.doubleToRawLongBits(WHOLE) >>> 52;

    private final int width;
    private final LongAdder undefined = new LongAdder();

    Quantiser(int width) {
        this.width = width;
    }

    /** How many pixels were set that are no number. */
    long undefinedPixels() {
        return undefined.sum();
    }

    /** Sets a rectangle's pixels: components, which are overwritten, are cut to [0, 1] and rounded to a step of 256. */
    void set(byte[] bytes, int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
        int pixels = columns * rows;
        toSteps(red, pixels);
        toSteps(green, pixels);
        toSteps(blue, pixels);
        boolean defined = true;
        for (int row = 0; row < rows; row++) {
            int to = COMPONENTS * ((y + row) * width + x);
            defined &= setRow(bytes, to, row * columns, columns, red, green, blue);
        }
        if (!defined) {
            countUndefined(pixels, red, green, blue);
        }
    }

    /**
     * floor(255 c + 1/2) of the double c exactly, plus 2^52. It is rounded once, to a whole number: rounding the
     * product before would decide the many colours such as .3 that are half a step but for their own last bit. The one
     * double that is half a step exactly is 1/2 (255 divides no other numerator), which rounds to the even 128, and so
     * upwards.
     */
    private static void toSteps(double[] c, int count) {
        for (int i = 0; i < count; i++) {
            c[i] = Math.fma(255, Math.min(1, Math.max(0, c[i])), WHOLE);
        }
    }

    /** Sets a row's bytes from steps; returns whether all are numbers. */
    private static boolean setRow(
            byte[] bytes, int to, int from, int count, double[] red, double[] green, double[] blue) {
        long all = 0;
        int at = to;
        for (int i = from; i < from + count; i++) {
            long r = Double.doubleToRawLongBits(red[i]);
            long g = Double.doubleToRawLongBits(green[i]);
            long b = Double.doubleToRawLongBits(blue[i]);
            bytes[at] = (byte) r;
            bytes[at + 1] = (byte) g;
            bytes[at + 2] = (byte) b;
            all |= r | g | b;
            at += COMPONENTS;
        }
        return all >>> 52 == EXPONENT;
    }

    private void countUndefined(int count, double[] red, double[] green, double[] blue) {
        for (int i = 0; i < count; i++) {
            if (Double.isNaN(red[i] + green[i] + blue[i])) {
                undefined.increment();
            }
        }
    }
}
