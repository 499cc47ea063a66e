package raytracer.files;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Pattern;
import raytracer.image.PngFile;

/**
 * Where a picture goes.
 *
 * @param file null for standard output
 */
public record Destination(Path file, OutputStream standardOutput) {

    /** In place of a file's name: standard input or output. */
    public static final String STANDARD = "-";

    private static final String SUFFIX = ".png";

    /** Of pictures of another kind: whoever names a file so expects that kind. */
    private static final Pattern OTHER_SUFFIX = Pattern.compile("(?i).*\\.(jpe?g|gif|bmp|tiff?|webp|ppm|pfm|exr|svg|pdf)");

    /** Where a user says. */
    public static Destination ofUser(String name, OutputStream out) throws UsageException, IOException {
        if (OTHER_SUFFIX.matcher(name).matches()) {
            throw new UsageException("expected -o to name a PNG, found '" + name + "'");
        }
        return new Destination(name.equals(STANDARD) ? null : Reason.path(name), out);
    }

    /** In a folder, by the name of the scene. */
    public static Destination inFolder(String folder, Path scene, OutputStream out) throws IOException {
        return new Destination(Reason.path(folder).resolve(baseName(scene) + SUFFIX), out);
    }

    /**
     * Where a scene says. It may be somebody else's: what it names is a picture, and stays in the working directory.
     *
     * @param place of the name in the scene, for messages
     */
    public static Destination ofScene(String name, String place, OutputStream out) throws UsageException, IOException {
        if (name.codePoints().anyMatch(c -> Character.isISOControl(c) || Character.getType(c) == Character.FORMAT)) {
            throw refused(name, place, "to have no control characters");
        }
        if (!name.toLowerCase(Locale.ROOT).endsWith(SUFFIX)) {
            throw refused(name, place, "to end in '" + SUFFIX + "'");
        }
        Path file;
        try {
            file = Reason.path(name);
        } catch (IOException e) {
            throw new UsageException(place, e.getMessage());
        }
        boolean leaves = file.getRoot() != null;
        for (Path step : file) {
            leaves |= step.toString().equals("..");
        }
        Path folder = OutputFile.folder(OutputFile.place(file));
        if (leaves || Files.isDirectory(folder) && !folder.toRealPath().startsWith(Path.of(".").toRealPath())) {
            throw refused(name, place, "to be inside the working directory");
        }
        return new Destination(file, out);
    }

    private static UsageException refused(String name, String place, String expectation) {
        return new UsageException(
                place, "expected 'output' " + expectation + ", found '" + name + "'; -o FILE writes anywhere");
    }

    public void write(BufferedImage picture) throws IOException {
        if (file != null) {
            OutputFile.write(file, out -> PngFile.write(picture, out));
            return;
        }
        try {
            PngFile.write(picture, new BufferedOutputStream(standardOutput));
        } catch (IOException e) {
            throw new IOException("cannot write to standard output: " + Reason.of(e), e);
        }
    }

    /** Where a picture of differences goes: NAME-diff.png beside NAME.png; null if there is no place beside it. */
    public Path ofDifferences() {
        return file == null ? Path.of("difference.png") : OutputFile.isDevice(file) ? null : ofDifferences(file);
    }

    public static Path ofDifferences(Path picture) {
        return picture.resolveSibling(baseName(picture) + "-diff.png");
    }

    /** The name of a picture or scene without its suffix. */
    static String baseName(Path file) {
        String name = baseName(file, SUFFIX);
        return name.endsWith(".scene") ? name.substring(0, name.length() - ".scene".length()) : name;
    }

    /** A file's name without a suffix, if it has that. */
    public static String baseName(Path file, String suffix) {
        String name = file.getFileName().toString();
        return name.toLowerCase(Locale.ROOT).endsWith(suffix) ? name.substring(0, name.length() - suffix.length()) : name;
    }

    @Override
    public String toString() {
        return file == null ? "to standard output" : file.toString();
    }
}
