package raytracer.image;

import java.awt.image.BufferedImage;
import raytracer.tracer.PixelSink;

/** A picture of 8 bits a component. Threads may set different pixels at the same time. */
public final class Image implements PixelSink {

    private static final int COMPONENTS = 3;

    /** What a Java array of bytes can hold. */
    private static final long MOST_BYTES = Integer.MAX_VALUE - 8;

    private final int width;
    private final int height;
    private final byte[] bytes;
    private final Quantiser quantiser;

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
        quantiser = new Quantiser(width);
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

    @Override
    public void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
        quantiser.set(bytes, x, y, columns, rows, red, green, blue);
    }

    /** A pixel as 0xRRGGBB. */
    public int rgb(int x, int y) {
        int i = COMPONENTS * (y * width + x);
        return (bytes[i] & 255) << 16 | (bytes[i + 1] & 255) << 8 | bytes[i + 2] & 255;
    }

    /** How many pixels were set to no number: none, unless the tracer has a fault. */
    public long undefinedPixels() {
        return quantiser.undefinedPixels();
    }

    /** Whether all pixels are black, when all have been set. */
    public boolean isBlack() {
        return quantiser.isBlack();
    }

    /** The same bytes as the standard library's picture. */
    public BufferedImage toBufferedImage() {
        return Rgb.picture(bytes, width, height);
    }
}
