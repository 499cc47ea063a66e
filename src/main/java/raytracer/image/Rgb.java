package raytracer.image;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;

/** The standard library's view of bytes that are red, green and blue in turns. */
final class Rgb {

    private Rgb() { }

    static ComponentColorModel colours() {
        return new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE);
    }

    /** Without a copy. */
    static WritableRaster raster(byte[] bytes, int width, int height) {
        int[] offsets = {0, 1, 2};
        return Raster.createInterleavedRaster(
                new DataBufferByte(bytes, bytes.length), width, height, 3 * width, 3, offsets, null);
    }
}
