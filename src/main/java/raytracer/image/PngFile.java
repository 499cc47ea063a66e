package raytracer.image;

import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.FileImageOutputStream;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes pictures as PNG, so that a file of that name is at all times either the old one or the whole new one. */
public final class PngFile {

    private PngFile() { }

    /** Loads the library's encoder, which takes a while the first time: for a thread that has nothing else to do. */
    public static void prepare() {
        ImageIO.getImageWritersByFormatName("png").next().dispose();
    }

    /**
     * Writes a picture to a temporary file beside its place and moves it there. If the program is interrupted, the
     * temporary file goes with it.
     *
     * @throws IOException if it cannot; then what was there is unchanged, and no other file is left
     */
    public static void write(RenderedImage picture, Path file) throws IOException {
        Path place = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        if (Files.exists(place) && !Files.isRegularFile(place)) {
            // A device or pipe such as /dev/null: it cannot be replaced or rewound, and holds nothing to be kept.
            try (OutputStream device = Files.newOutputStream(place)) {
                write(picture, device);
            }
            return;
        }
        // The process's number would tell more, but loads a thread pool.
        Path temporary = place.resolveSibling("." + place.getFileName() + "." + System.nanoTime() + ".tmp");
        Thread cleaner = new Thread(() -> delete(temporary), "cleaner");
        Runtime.getRuntime().addShutdownHook(cleaner);
        try {
            Files.createFile(temporary);
            try (ImageOutputStream out = new FileImageOutputStream(temporary.toFile())) {
                encode(picture, out);
            }
            move(temporary, place);
        } finally {
            delete(temporary);
            forget(cleaner);
        }
    }

    /** Writes a picture to a stream, and leaves it open. */
    public static void write(RenderedImage picture, OutputStream stream) throws IOException {
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(stream)) {
            encode(picture, out);
        }
        stream.flush();
    }

    private static void delete(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            // Its folder has gone or become read-only: nothing can be done about the file, and the cause is told.
        }
    }

    private static void forget(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The program is going down already, and the hook with it.
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static void encode(RenderedImage picture, ImageOutputStream out) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try {
            writer.setOutput(out);
            writer.write(new IIOImage(picture, null, null));
        } finally {
            writer.dispose();
        }
    }
}
