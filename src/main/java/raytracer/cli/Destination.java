package raytracer.cli;

import java.awt.image.RenderedImage;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import raytracer.image.PngFile;
import raytracer.parser.ParsedScene;

/**
 * Where a picture goes.
 *
 * @param file null for standard output
 */
record Destination(Path file, PrintStream standardOutput) {

    private static final String SUFFIX = ".png";

    /** As the options say, or else the scene. */
    static Destination of(Options options, ParsedScene scene, PrintStream out) throws UsageException, IOException {
        if (Options.STANDARD.equals(options.output())) {
            return new Destination(null, out);
        }
        return new Destination(
                options.output() != null ? Reason.path(options.output()) : ofScene(scene), out);
    }

    /** A scene may be somebody else's: what it names is a picture, and stays in the working directory. */
    private static Path ofScene(ParsedScene scene) throws UsageException, IOException {
        String name = scene.scene().output();
        if (!name.equals(Terminal.harmless(name))) {
            throw refused(scene, "to have no control characters");
        }
        if (!name.toLowerCase(Locale.ROOT).endsWith(SUFFIX)) {
            throw refused(scene, "to end in '" + SUFFIX + "'");
        }
        Path file = Reason.path(name);
        boolean leaves = file.getRoot() != null;
        for (Path step : file) {
            leaves |= step.toString().equals("..");
        }
        Path folder = OutputFile.folder(OutputFile.place(file));
        if (leaves || Files.isDirectory(folder) && !folder.toRealPath().startsWith(Path.of(".").toRealPath())) {
            throw refused(scene, "to be inside the working directory");
        }
        return file;
    }

    private static UsageException refused(ParsedScene scene, String expectation) {
        return new UsageException(scene.outputPlace(), "expected 'output' " + expectation + ", found '"
                + scene.scene().output() + "'; -o FILE writes anywhere");
    }

    void write(RenderedImage picture) throws IOException {
        try {
            if (file != null) {
                OutputFile.write(file, out -> PngFile.write(picture, out));
                return;
            }
            PngFile.write(picture, new BufferedOutputStream(standardOutput));
            if (standardOutput.checkError()) {
                throw new IOException("whoever was to read it has gone");
            }
        } catch (IOException e) {
            throw new IOException("cannot write " + this + ": " + Reason.of(e), e);
        }
    }

    /** Where a picture of differences goes: NAME-diff.png beside NAME.png; null if there is no place beside it. */
    Path ofDifferences() {
        return file == null ? Path.of("difference.png") : OutputFile.isDevice(file) ? null : ofDifferences(file);
    }

    static Path ofDifferences(Path picture) {
        return picture.resolveSibling(baseName(picture, SUFFIX) + "-diff.png");
    }

    /** A file's name without a suffix, if it has that. */
    static String baseName(Path file, String suffix) {
        String name = file.getFileName().toString();
        return name.toLowerCase(Locale.ROOT).endsWith(suffix) ? name.substring(0, name.length() - suffix.length()) : name;
    }

    @Override
    public String toString() {
        return file == null ? "to standard output" : file.toString();
    }
}
