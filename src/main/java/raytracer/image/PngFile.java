package raytracer.image;

import java.io.File;
import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/** Writes pictures as PNG, so that a file of that name is at all times either the old one or the whole new one. */
public final class PngFile {

    private PngFile() { }

    /**
     * Writes a picture to a temporary file beside its place and moves it there.
     *
     * @throws IOException if it cannot; then what was there is unchanged, and no other file is left
     */
    public static void write(Image image, Path file) throws IOException {
        Path place = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        if (Files.exists(place) && !Files.isRegularFile(place)) {
            // A device such as /dev/null: it cannot be replaced, and holds nothing to be kept.
            encode(image, place.toFile());
            return;
        }
        Path temporary = place.resolveSibling("." + place.getFileName() + "." + ProcessHandle.current().pid() + ".tmp");
        try {
            Files.createFile(temporary);
            encode(image, temporary.toFile());
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

    private static void encode(Image image, File file) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try (ImageOutputStream out = ImageIO.createImageOutputStream(file)) {
            if (out == null) {
                throw new IOException("it cannot be opened for writing");
            }
            writer.setOutput(out);
            writer.write(new IIOImage(image.toBufferedImage(), null, null));
        } finally {
            writer.dispose();
        }
    }
}
