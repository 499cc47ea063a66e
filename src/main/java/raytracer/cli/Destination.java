package raytracer.cli;

import java.awt.image.RenderedImage;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import raytracer.image.PngFile;
import raytracer.scene.Scene;

/**
 * Where a picture goes.
 *
 * @param file null for standard output
 */
record Destination(Path file, PrintStream standardOutput) {

    /** As the options say, or else the scene. That is somebody else's: what it names stays in the working directory. */
    static Destination of(Options options, Scene scene, PrintStream out) throws UsageException, IOException {
        if (Options.STANDARD.equals(options.output())) {
            return new Destination(null, out);
        }
        if (options.output() != null) {
            return new Destination(Reason.path(options.output()), out);
        }
        Path named = Reason.path(scene.output());
        for (Path step : named) {
            if (named.isAbsolute() || step.toString().equals("..")) {
                throw new UsageException("expected 'output' to be inside the working directory, found '"
                        + scene.output() + "'; -o FILE writes anywhere");
            }
        }
        return new Destination(named, out);
    }

    /** Sees to it that rendering is not in vain. */
    void requireFolder() throws IOException {
        if (file == null) {
            return;
        }
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || Files.isDirectory(file)) {
            throw new IOException("cannot write " + file + ": it is a directory");
        }
        if (!Files.isDirectory(folder)) {
            throw new IOException("cannot write " + file + ": there is no directory " + folder + "; make it first");
        }
        if (!Files.exists(file) && !Files.isWritable(folder)) {
            throw new IOException("cannot write " + file + ": no permission to make files in " + folder);
        }
    }

    void write(RenderedImage picture) throws IOException {
        try {
            if (file != null) {
                PngFile.write(picture, file);
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

    /** The file that a picture of differences goes to: NAME-diff.png beside NAME.png. */
    Path ofDifferences() {
        if (file == null) {
            return Path.of("difference.png");
        }
        String name = file.getFileName().toString();
        int dot = name.toLowerCase(java.util.Locale.ROOT).endsWith(".png") ? name.length() - 4 : name.length();
        return file.resolveSibling(name.substring(0, dot) + "-diff.png");
    }

    @Override
    public String toString() {
        return file == null ? "to standard output" : file.toString();
    }
}
