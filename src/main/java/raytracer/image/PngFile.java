package raytracer.image;

import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes pictures as PNG. */
public final class PngFile {

    private PngFile() { }

    /** Loads the library's encoder, which takes a while the first time: for a thread that has nothing else to do. */
    public static void prepare() {
        ImageIO.getImageWritersByFormatName("png").next().dispose();
    }

    /** Writes a picture to a stream, and leaves it open. */
    public static void write(RenderedImage picture, OutputStream stream) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(stream)) {
            writer.setOutput(out);
            writer.write(new IIOImage(picture, null, null));
        } finally {
            writer.dispose();
        }
        stream.flush();
    }
}
