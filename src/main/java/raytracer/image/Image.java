package raytracer.image;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.util.concurrent.atomic.AtomicLong;
import raytracer.tracer.PixelSink;

/** A picture of 8 bits a component. Threads may set different pixels at the same time. */
public final class Image implements PixelSink {

    private static final int COMPONENTS = 3;

    /** What a Java array of bytes can hold. */
    private static final long MAX_BYTES = Integer.MAX_VALUE - 8;

    private final BufferedImage picture;

    /** Its components, row by row: blue, green and red of each pixel. */
    private final byte[] bytes;

    private final AtomicLong undefinedPixels = new AtomicLong();
    private final AtomicLong cutPixels = new AtomicLong();

    /**
     * A black picture.
     *
     * @throws IllegalArgumentException if it would be more than 2 GB
     */
    public Image(int width, int height) {
        if (bytes(width, height) > MAX_BYTES) {
            throw new IllegalArgumentException(width + "x" + height + " is larger than a picture in memory can be");
        }
        picture = new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR);
        bytes = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
    }

    /** The memory that a picture takes; the greatest long if it is beyond that. */
    public static long bytes(int width, int height) {
        long pixels = (long) width * height;
        return pixels > Long.MAX_VALUE / COMPONENTS ? Long.MAX_VALUE : COMPONENTS * pixels;
    }

    @Override
    public void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
        int width = picture.getWidth(), cut = 0;
        for (int i = 0; i < columns * rows; i++) {
            int at = COMPONENTS * ((y + i / columns) * width + x + i % columns);
            bytes[at] = Quantiser.quantise(blue[i]);
            bytes[at + 1] = Quantiser.quantise(green[i]);
            bytes[at + 2] = Quantiser.quantise(red[i]);
            cut += red[i] > 1 || green[i] > 1 || blue[i] > 1 ? 1 : 0;
            if (Double.isNaN(red[i] + green[i] + blue[i])) {
                undefinedPixels.incrementAndGet();
            }
        }
        cutPixels.addAndGet(cut);
    }

    /** A pixel as 0xRRGGBB. */
    public int rgb(int x, int y) {
        return picture.getRGB(x, y) & 0xFFFFFF;
    }

    /** How many pixels were set to no number (they are 0): none, unless the tracer has a fault. */
    public long undefinedPixels() {
        return undefinedPixels.get();
    }

    /** How many pixels, as they were set, had a component above 1. */
    public long cutPixels() {
        return cutPixels.get();
    }

    public boolean isBlack() {
        for (byte b : bytes) {
            if (b != 0) {
                return false;
            }
        }
        return true;
    }

    /** This as the standard library's picture; not a copy. */
    public BufferedImage toBufferedImage() {
        return picture;
    }
}
