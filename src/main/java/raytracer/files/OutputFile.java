package raytracer.files;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;

/**
 * Writes files so that one of a name is at all times either the old one or the whole new one: to a temporary file
 * beside it, which is moved there. If the program is interrupted, the temporary file goes with it.
 */
public final class OutputFile {

    /** More than any sensible chain of symbolic links has. */
    private static final int MAX_LINKS = 40;

    /** What a file is to hold. */
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    private final Path temporary;
    private boolean interrupted;

    private OutputFile(Path temporary) {
        this.temporary = temporary;
    }

    /** Sees to it that what is yet to be made is not made in vain. */
    public static void require(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException("cannot write " + file + ": it is a directory");
        }
        if (isDevice(file)) {
            return;
        }
        Path place = place(file);
        Path folder = folder(place);
        if (!Files.isDirectory(folder)) {
            throw new IOException("cannot write " + file + ": there is no directory " + folder + "; make it first");
        }
        if (Files.exists(place) && isProtected(place)) {
            throw new IOException("cannot write " + file + ": it is write-protected");
        }
        if (!Files.isWritable(folder)) {
            throw new IOException("cannot write " + file + ": no permission to make files in " + folder);
        }
    }

    /**
     * Writes a file, or into a device or pipe, which holds nothing to be kept.
     *
     * @throws IOException if it cannot, and says why; then what was there is unchanged, and no other file is left
     */
    public static void write(Path file, Content content) throws IOException {
        try {
            if (isDevice(file)) {
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file, StandardOpenOption.WRITE))) {
                    content.writeTo(out);
                }
                return;
            }
            Path place = place(file);
            // The process's number would tell more, but loads a thread pool.
            new OutputFile(place.resolveSibling(".raytracer-" + System.nanoTime() + ".tmp")).replace(place, content);
        } catch (IOException e) {
            throw new IOException("cannot write " + file + ": " + Reason.of(e), e);
        }
    }

    /** The same of a text, in UTF-8. */
    public static void write(Path file, String text) throws IOException {
        write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    /** Whether a file is something other than a regular file: a terminal, a pipe, {@code /dev/null}. */
    static boolean isDevice(Path file) {
        return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
    }

    /** The file itself, where a name may be that of a link to it; it need not be there. */
    public static Path place(Path file) throws IOException {
        Path place = file;
        for (int links = 0; Files.isSymbolicLink(place); links++) {
            if (links == MAX_LINKS) {
                throw new IOException("too many symbolic links");
            }
            place = place.resolveSibling(Files.readSymbolicLink(place));
        }
        return place;
    }

    /** The folder that a file is in. A relative one stays relative: Java may not know the working directory's name. */
    public static Path folder(Path file) {
        return file.getParent() == null ? Path.of(".") : file.getParent();
    }

    /** A file that its owner may not write is protected, even if the superuser could. */
    private static boolean isProtected(Path file) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        return !Files.isWritable(file)
                || posix != null && !posix.readAttributes().permissions().contains(PosixFilePermission.OWNER_WRITE);
    }

    private void replace(Path place, Content content) throws IOException {
        Thread cleaner = new Thread(this::interrupt, "cleaner");
        Runtime.getRuntime().addShutdownHook(cleaner);
        try {
            try (OutputStream out = new BufferedOutputStream(open())) {
                content.writeTo(out);
            }
            PosixFileAttributeView old = Files.getFileAttributeView(place, PosixFileAttributeView.class);
            if (old != null && Files.exists(place)) {
                Files.setPosixFilePermissions(temporary, old.readAttributes().permissions());
            }
            move(place);
        } finally {
            delete();
            forget(cleaner);
        }
    }

    /** Opens the temporary file, once: whoever opened it again after an interrupt would make it again. */
    private synchronized OutputStream open() throws IOException {
        if (interrupted) {
            throw new InterruptedIOException("interrupted");
        }
        return Files.newOutputStream(temporary, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    }

    private synchronized void interrupt() {
        interrupted = true;
        delete();
    }

    private void delete() {
        try {
            Files.deleteIfExists(temporary);
        } catch (IOException e) {
            // Its folder has gone or become read-only: nothing can be done about the file, and the cause is told.
        }
    }

    private void move(Path to) throws IOException {
        try {
            Files.move(temporary, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(temporary, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static void forget(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The program is going down already, and the hook with it.
        }
    }
}
