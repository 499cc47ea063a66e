package raytracer.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import javax.imageio.IIOException;

/** Why a file operation failed, in words; the library's messages for some are just the file's name. */
public final class Reason {

    private Reason() { }

    public static String of(IOException e) {
        if (e instanceof NoSuchFileException) {
            return "no such file or directory";
        }
        if (e instanceof AccessDeniedException) {
            return "permission denied";
        }
        if (e instanceof FileSystemException system && system.getReason() != null) {
            return system.getReason();
        }
        if (e instanceof IIOException && e.getCause() instanceof IOException cause) {
            return of(cause);
        }
        return e.getMessage() == null ? e.toString() : e.getMessage();
    }

    /**
     * What helps if a name or the working directory has characters that Java cannot express in this locale; else
     * nothing.
     */
    public static String ofEncoding(String name) {
        String names = name + System.getProperty("user.dir");
        boolean lost = names.chars().anyMatch(c -> c > 126 || c == '?');
        return lost ? "; Java cannot express its name or its folder's in this locale: run it with LC_ALL=C.UTF-8" : "";
    }

    /** A file by its name. */
    public static Path path(String name) throws IOException {
        try {
            return Path.of(name);
        } catch (InvalidPathException e) {
            throw new IOException("not a file name: " + e.getReason() + ofEncoding(name), e);
        }
    }
}
