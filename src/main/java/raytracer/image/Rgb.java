package raytracer.image;

import java.awt.Point;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;

/** The standard library's view of bytes that are red, green and blue in turns. */
final class Rgb {

    private static final int COMPONENTS = 3;

    private Rgb() { }

    static ComponentColorModel colours() {
        return new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE);
    }

    /** Rows of pixels without a copy; the first row has this number. */
    static WritableRaster rows(byte[] bytes, int width, int rows, int first) {
        int[] offsets = {0, 1, 2};
        return Raster.createInterleavedRaster(new DataBufferByte(bytes, bytes.length), width, rows, COMPONENTS * width,
                COMPONENTS, offsets, new Point(0, first));
    }

    static BufferedImage picture(byte[] bytes, int width, int height) {
        return new BufferedImage(colours(), rows(bytes, width, height, 0), false, null);
    }
}
