package raytracer.image;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * A picture that is there already, of any kind that the library reads. Its size is known before its pixels are read;
 * these are its samples as they stand, in 8 bits: the library's own conversion of grey would make it brighter.
 */
public record PictureFile(ImageInputStream stream, ImageReader reader) implements Closeable {

    /**
     * Opens a picture.
     *
     * @param in read as far as needed; not closed
     * @return null if it is none that the library reads
     */
    public static PictureFile open(InputStream in) throws IOException {
        ImageInputStream stream = new MemoryCacheImageInputStream(in);
        Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
        if (!readers.hasNext()) {
            stream.close();
            return null;
        }
        ImageReader reader = readers.next();
        reader.setInput(stream, true, true);
        return new PictureFile(stream, reader);
    }

    /** Something to be read from it. */
    private interface Reading<T> {
        T get() throws IOException;
    }

    /** Whatever the library finds wrong, in its own classes' words, the picture is damaged. */
    private static <T> T whole(Reading<T> reading) throws IOException {
        try {
            return reading.get();
        } catch (IOException | RuntimeException e) {
            throw new IOException("it is damaged", e);
        }
    }

    public int width() throws IOException {
        return whole(() -> reader.getWidth(0));
    }

    public int height() throws IOException {
        return whole(() -> reader.getHeight(0));
    }

    /** The pixels, as 0xRRGGBB of an opaque picture. */
    public BufferedImage read() throws IOException {
        BufferedImage picture = whole(() -> reader.read(0));
        int w = picture.getWidth(), h = picture.getHeight();
        BufferedImage samples = new BufferedImage(w, h, BufferedImage.TYPE_INT_RGB);
        boolean byPalette = picture.getColorModel() instanceof IndexColorModel;
        for (int y = 0; y < h; y++) {
            int[] row = byPalette ? picture.getRGB(0, y, w, 1, null, 0, w)
                    : samples(picture.getRaster(), picture.getColorModel().getComponentSize(0), y);
            samples.setRGB(0, y, w, 1, row, 0, w);
        }
        return samples;
    }

    private static int[] samples(Raster raster, int bits, int y) {
        int bands = raster.getNumBands(), max = (1 << bits) - 1;
        int green = bands >= 3 ? 1 : 0, blue = bands >= 3 ? 2 : 0;
        int[] all = raster.getPixels(0, y, raster.getWidth(), 1, (int[]) null);
        int[] row = new int[raster.getWidth()];
        for (int x = 0; x < row.length; x++) {
            int at = bands * x;
            row[x] = to8Bits(all[at], max) << 16 | to8Bits(all[at + green], max) << 8 | to8Bits(all[at + blue], max);
        }
        return row;
    }

    private static int to8Bits(int sample, int max) {
        return (255 * sample + max / 2) / max;
    }

    @Override
    public void close() throws IOException {
        reader.dispose();
        stream.close();
    }
}
