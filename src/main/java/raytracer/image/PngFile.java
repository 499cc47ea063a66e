package raytracer.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes pictures as PNG. */
public final class PngFile {

    private PngFile() { }

    /**
     * Lets a thread of its own write a small picture to nowhere: the first one takes the library a tenth of a second. What
     * goes wrong goes wrong again when a picture is written, and is told then.
     */
    public static void prepare() {
        Thread thread = new Thread(new FutureTask<>(() -> {
            write(new BufferedImage(16, 16, BufferedImage.TYPE_3BYTE_BGR), OutputStream.nullOutputStream());
            return null;
        }), "encoder");
        thread.setDaemon(true);
        thread.start();
    }

    /** Writes a picture to a stream, and leaves it open. */
    public static void write(BufferedImage picture, OutputStream stream) throws IOException {
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(stream)) {
            ImageIO.write(picture, "png", out);
        }
        stream.flush();
    }
}
