package raytracer.image;

import java.awt.Rectangle;
import java.awt.image.ColorModel;
import java.awt.image.Raster;
import java.awt.image.RenderedImage;
import java.awt.image.SampleModel;
import java.awt.image.WritableRaster;
import java.util.Vector;
import java.util.concurrent.atomic.AtomicReferenceArray;
import raytracer.tracer.PixelSink;

/**
 * A picture that is encoded while it is being rendered: threads set pixels in bands of rows, the encoder takes rows
 * from the top, and a band is forgotten when it has been taken. Whoever is ahead waits, so that memory does not grow
 * with the picture's height.
 */
public final class RowStream implements PixelSink, RenderedImage {

    /** The memory for bands that the encoder has not taken yet; one band at least is let in. */
    private static final long MOST_BYTES = 32 << 20;

    private static final int COMPONENTS = 3;

    private final int width;
    private final int height;
    private final int bandRows;
    private final Quantiser quantiser;
    /** Band number b is at place b modulo the length. */
    private final AtomicReferenceArray<Band> bands;
    private int firstBand;
    private RuntimeException failure;

    /** Some rows, and how many of their pixels are still to come. */
    private static final class Band {
        private final byte[] bytes;
        private int missing;

        Band(int pixels) {
            bytes = new byte[COMPONENTS * pixels];
            missing = pixels;
        }
    }

    /** @param bandRows the rows of the tiles in which pixels come */
    public RowStream(int width, int height, int bandRows) {
        this.width = width;
        this.height = height;
        this.bandRows = bandRows;
        quantiser = new Quantiser(width);
        Math.multiplyExact(COMPONENTS * bandRows, width);
        long most = Math.max(2, MOST_BYTES / ((long) COMPONENTS * bandRows * width));
        bands = new AtomicReferenceArray<>((int) Math.min(most, (height - 1L) / bandRows + 1));
    }

    private int place(int row) {
        return row / bandRows % bands.length();
    }

    @Override
    public synchronized void awaitRoom(int row) {
        int band = row / bandRows;
        while (band >= firstBand + bands.length() && failure == null) {
            await();
        }
        throwFailure();
        if (bands.get(place(row)) == null) {
            bands.set(place(row), new Band(width * Math.min(bandRows, height - row)));
        }
    }

    @Override
    public void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
        quantiser.set(bands.get(place(y)).bytes, x, y % bandRows, columns, rows, red, green, blue);
    }

    @Override
    public synchronized void tileDone(int row, int pixels) {
        Band band = bands.get(place(row));
        band.missing -= pixels;
        if (band.missing == 0) {
            notifyAll();
        }
    }

    /** How many pixels were set to no number: none, unless the tracer has a fault. */
    public long undefinedPixels() {
        return quantiser.undefinedPixels();
    }

    /** Whether all pixels are black, when all have been set. */
    public boolean isBlack() {
        return quantiser.isBlack();
    }

    /** Lets all who wait or will ask fail with this, as the other side has failed. */
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

    private void await() {
        try {
            wait();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            fail(new IllegalStateException("interrupted", e));
        }
    }

    /** Rows for the encoder, which asks for them once and from the top. */
    @Override
    public synchronized Raster getData(Rectangle area) {
        int index = area.y / bandRows;
        for (; firstBand < index; firstBand++) {
            bands.set(firstBand % bands.length(), null);
            notifyAll();
        }
        Band band;
        while (((band = bands.get(place(area.y))) == null || band.missing > 0) && failure == null) {
            await();
        }
        throwFailure();
        int top = index * bandRows;
        return Rgb.rows(band.bytes, width, Math.min(bandRows, height - top), top)
                .createChild(area.x, area.y, area.width, area.height, area.x, area.y, null);
    }

    @Override
    public int getWidth() {
        return width;
    }

    @Override
    public int getHeight() {
        return height;
    }

    @Override
    public ColorModel getColorModel() {
        return Rgb.colours();
    }

    @Override
    public SampleModel getSampleModel() {
        return Rgb.rows(new byte[COMPONENTS * width], width, 1, 0).getSampleModel();
    }

    // The bands are its tiles: an encoder may ask for a tile instead of rows if there is only one.

    @Override
    public int getTileWidth() {
        return width;
    }

    @Override
    public int getTileHeight() {
        return bandRows;
    }

    @Override
    public int getNumXTiles() {
        return 1;
    }

    @Override
    public int getNumYTiles() {
        return (height - 1) / bandRows + 1;
    }

    @Override
    public int getMinX() {
        return 0;
    }

    @Override
    public int getMinY() {
        return 0;
    }

    @Override
    public int getMinTileX() {
        return 0;
    }

    @Override
    public int getMinTileY() {
        return 0;
    }

    @Override
    public int getTileGridXOffset() {
        return 0;
    }

    @Override
    public int getTileGridYOffset() {
        return 0;
    }

    @Override
    public Vector<RenderedImage> getSources() {
        return new Vector<>();
    }

    @Override
    public Object getProperty(String name) {
        return java.awt.Image.UndefinedProperty;
    }

    @Override
    public String[] getPropertyNames() {
        return new String[0];
    }

    @Override
    public Raster getData() {
        throw new UnsupportedOperationException("the picture is never there as a whole");
    }

    @Override
    public Raster getTile(int x, int y) {
        int top = y * bandRows;
        return getData(new Rectangle(0, top, width, Math.min(bandRows, height - top)));
    }

    @Override
    public WritableRaster copyData(WritableRaster raster) {
        throw new UnsupportedOperationException("the picture is never there as a whole");
    }
}
