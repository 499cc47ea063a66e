package raytracer.image;

import java.awt.image.BufferedImage;
import java.util.concurrent.atomic.LongAdder;
import raytracer.tracer.PixelSink;

/**
 * A picture of 8 bits a component, and the one place where linear colour becomes bytes. Threads may set different
 * pixels at the same time.
 */
public final class Image implements PixelSink {

    private static final int COMPONENTS = 3;

    /** What a Java array of bytes can hold. */
    private static final long MOST_BYTES = Integer.MAX_VALUE - 8;

    private final int width;
    private final int height;
    private final byte[] bytes;
    private final LongAdder undefined = new LongAdder();

    /**
     * A black picture.
     *
     * @throws IllegalArgumentException if it would be more than 2 GB
     */
    public Image(int width, int height) {
        if (bytes(width, height) > MOST_BYTES) {
            throw new IllegalArgumentException(width + "x" + height + " is larger than a picture in memory can be");
        }
        this.width = width;
        this.height = height;
        bytes = new byte[COMPONENTS * width * height];
    }

    /** The memory that a picture takes; the greatest long if it is beyond that. */
    public static long bytes(int width, int height) {
        long pixels = (long) width * height;
        return pixels > Long.MAX_VALUE / COMPONENTS ? Long.MAX_VALUE : COMPONENTS * pixels;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** Sets pixels; each component is cut to [0, 1] and rounded to the nearest of 256 steps. */
    @Override
    public void setRow(int x, int y, int count, double[] red, double[] green, double[] blue, int from) {
        quantise(red, green, blue, from, count, bytes, COMPONENTS * (y * width + x), undefined);
    }

    /** Turns pixels into bytes, from the one at index {@code to} on, and counts those that are no number. */
    static void quantise(double[] red, double[] green, double[] blue, int from, int count, byte[] bytes, int to,
            LongAdder undefined) {
        int at = to;
        for (int i = from; i < from + count; i++) {
            bytes[at++] = quantise(red[i]);
            bytes[at++] = quantise(green[i]);
            bytes[at++] = quantise(blue[i]);
            if (Double.isNaN(red[i] + green[i] + blue[i])) {
                undefined.increment();
            }
        }
    }

    /** A pixel as 0xRRGGBB. */
    public int rgb(int x, int y) {
        int i = COMPONENTS * (y * width + x);
        return (bytes[i] & 255) << 16 | (bytes[i + 1] & 255) << 8 | bytes[i + 2] & 255;
    }

    /** How many pixels were set to no number: none, unless the tracer has a fault. */
    public long undefinedPixels() {
        return undefined.sum();
    }

    /**
     * floor(255 c + 1/2) of the double c exactly. It is rounded once, to a whole number: rounding the product before
     * would decide the many colours such as .3 that are half a step but for their own last bit. The one double that is
     * half a step exactly is 1/2 (255 divides no other numerator), which rounds to the even 128, and so upwards. NaN
     * becomes 0.
     */
    static byte quantise(double c) {
        if (!(c > 0)) {
            return 0;
        }
        if (c >= 1) {
            return (byte) 255;
        }
        // From 2^52 on doubles are whole numbers, which are in their last bits.
        return (byte) Double.doubleToRawLongBits(Math.fma(255, c, 0x1p52));
    }

    /** The same bytes as the standard library's picture. */
    public BufferedImage toBufferedImage() {
        return Rgb.picture(bytes, width, height);
    }
}
