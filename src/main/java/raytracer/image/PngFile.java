package raytracer.image;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
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
        try (ImageOutputStream nowhere = new MemoryCacheImageOutputStream(OutputStream.nullOutputStream())) {
            encode(new Image(1, 1), nowhere);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Writes a picture to a temporary file beside its place and moves it there.
     *
     * @throws IOException if it cannot; then what was there is unchanged, and no other file is left
     */
    public static void write(Image image, Path file) throws IOException {
        Path place = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        if (Files.exists(place) && !Files.isRegularFile(place)) {
            // A device or pipe such as /dev/null: it cannot be replaced or rewound, and holds nothing to be kept.
            try (OutputStream device = Files.newOutputStream(place);
                    ImageOutputStream out = new MemoryCacheImageOutputStream(device)) {
                encode(image, out);
            }
            return;
        }
        Path temporary = place.resolveSibling("." + place.getFileName() + "." + ProcessHandle.current().pid() + ".tmp");
        try {
            Files.createFile(temporary);
            try (ImageOutputStream out = new FileImageOutputStream(temporary.toFile())) {
                encode(image, out);
            }
            move(temporary, place);
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static void encode(Image image, ImageOutputStream out) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try {
            writer.setOutput(out);
            writer.write(new IIOImage(image.toBufferedImage(), null, null));
        } finally {
            writer.dispose();
        }
    }
}
