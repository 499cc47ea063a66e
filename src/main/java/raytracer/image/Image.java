package raytracer.image;

import java.awt.Rectangle;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.awt.image.RenderedImage;
import java.awt.image.WritableRaster;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import raytracer.tracer.PixelSink;

/**
 * A picture of 8 bits a component. Threads may set different pixels at the same time, and another may encode it
 * meanwhile: that one waits for each row until all of it has been set.
 */
public final class Image implements PixelSink {

    private static final int COMPONENTS = 3;

    /** What a Java array of bytes can hold. */
    private static final long MAX_BYTES = Integer.MAX_VALUE - 8;

    private final int width;
    private final int height;
    private final byte[] bytes;

    /** By row: how many pixels are still to be set. */
    private final int[] missing;

    private long undefinedPixels;
    private boolean isLit;
    private RuntimeException failure;

    /**
     * A black picture.
     *
     * @throws IllegalArgumentException if it would be more than 2 GB
     */
    public Image(int width, int height) {
        if (bytes(width, height) > MAX_BYTES) {
            throw new IllegalArgumentException(width + "x" + height + " is larger than a picture in memory can be");
        }
        this.width = width;
        this.height = height;
        bytes = new byte[COMPONENTS * width * height];
        missing = new int[height];
        Arrays.fill(missing, width);
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
        int undefined = 0;
        int anyBit = 0;
        for (int i = 0; i < columns * rows; i++) {
            int at = COMPONENTS * ((y + i / columns) * width + x + i % columns);
            bytes[at] = Quantiser.quantise(red[i]);
            bytes[at + 1] = Quantiser.quantise(green[i]);
            bytes[at + 2] = Quantiser.quantise(blue[i]);
            anyBit |= bytes[at] | bytes[at + 1] | bytes[at + 2];
            undefined += Double.isNaN(red[i] + green[i] + blue[i]) ? 1 : 0;
        }
        complete(y, rows, columns, undefined, anyBit != 0);
    }

    private synchronized void complete(int y, int rows, int columns, int undefined, boolean lit) {
        throwFailure();
        undefinedPixels += undefined;
        isLit |= lit;
        boolean anyRow = false;
        for (int row = y; row < y + rows; row++) {
            missing[row] -= columns;
            anyRow |= missing[row] <= 0;
        }
        if (anyRow) {
            notifyAll();
        }
    }

    /** Returns when all pixels of a row have been set. */
    private synchronized void awaitRow(int row) {
        while (missing[row] > 0 && failure == null) {
            try {
                wait();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                failure = new IllegalStateException("interrupted", e);
            }
        }
        throwFailure();
    }

    /** Lets all who set pixels or wait for them fail with this, as the other side has failed. */
    public synchronized void fail(RuntimeException reason) {
        if (failure == null) {
            failure = reason;
        }
        notifyAll();
    }

    private void throwFailure() {
        if (failure != null) {
            throw failure;
        }
    }

    /** A pixel as 0xRRGGBB. */
    public int rgb(int x, int y) {
        int i = COMPONENTS * (y * width + x);
        return (bytes[i] & 255) << 16 | (bytes[i + 1] & 255) << 8 | bytes[i + 2] & 255;
    }

    /** How many pixels were set to no number (they are 0): none, unless the tracer has a fault. */
    public synchronized long undefinedPixels() {
        return undefinedPixels;
    }

    /** Whether all pixels that were set are black. */
    public synchronized boolean isBlack() {
        return !isLit;
    }

    /** This as the standard library's picture; not a copy. */
    public BufferedImage toBufferedImage() {
        int[] offsets = {0, 1, 2};
        WritableRaster raster = Raster.createInterleavedRaster(
                new DataBufferByte(bytes, bytes.length), width, height, COMPONENTS * width, COMPONENTS, offsets, null);
        ColorModel colours = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE);
        return new BufferedImage(colours, raster, false, null);
    }

    /**
     * The picture for an encoder that asks for it row by row, while its pixels are still being set. Each row is a tile of
     * its own, for Java 25's encoder asks for tiles; and all is no BufferedImage, of which that takes the bytes at once.
     */
    public RenderedImage rowByRow() {
        BufferedImage picture = toBufferedImage();
        return (RenderedImage) Proxy.newProxyInstance(Image.class.getClassLoader(),
                new Class<?>[] {RenderedImage.class}, (proxy, method, arguments) -> switch (method.getName()) {
                    case "getTileHeight" -> 1;
                    case "getNumYTiles" -> height;
                    case "getTile" -> rows(picture, new Rectangle(0, (int) arguments[1], width, 1));
                    case "getData" -> rows(picture, arguments == null ? new Rectangle(0, 0, width, height)
                            : (Rectangle) arguments[0]);
                    default -> method.invoke(picture, arguments);
                });
    }

    private Raster rows(BufferedImage picture, Rectangle area) {
        for (int row = area.y; row < area.y + area.height; row++) {
            awaitRow(row);
        }
        return picture.getData(area);
    }
}
