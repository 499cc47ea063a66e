package raytracer.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Arrays;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Destination;
import raytracer.files.OutputFile;
import raytracer.files.Places;
import raytracer.files.Reason;
import raytracer.files.Reference;
import raytracer.files.UsageException;
import raytracer.image.Image;
import raytracer.parser.ParsedScene;

/**
 * The files that one job reads and writes besides its scene.
 *
 * @param destination of the picture; null if none is written
 * @param reference   what the picture is compared with; null if with none
 * @param difference  where a picture of the differences goes; null if nowhere
 */
record Outputs(Input input, Destination destination, Path reference, Path difference) {

    /**
     * @param scene     null if the input is a picture
     * @param otherwise where the picture goes if the scene names no output; null for the usual place
     */
    static Outputs of(Options options, Input input, ParsedScene scene, Destination otherwise, Terminal terminal)
            throws UsageException, IOException {
        Destination destination = scene == null ? null : destination(options, input, scene, otherwise, terminal);
        Path reference = options.has(Option.COMPARE) ? Reference.of(options.text(Option.COMPARE), input.path()) : null;
        Path difference = reference == null ? null : options.has(Option.DIFF) ? Reason.path(options.text(Option.DIFF))
                : destination != null ? destination.ofDifferences() : Destination.ofDifferences(input.path());
        return new Outputs(input, destination, reference, difference);
    }

    private static Destination destination(Options options, Input input, ParsedScene scene, Destination otherwise,
            Terminal terminal) throws UsageException, IOException {
        // Not through the stream that is printed to, which keeps to itself why it cannot be written.
        OutputStream out = terminal.out() == System.out ? new FileOutputStream(FileDescriptor.out) : terminal.out();
        if (options.has(Option.OUTPUT)) {
            return options.isOutputFolder() ? Destination.inFolder(options.text(Option.OUTPUT), input.path(), out)
                    : Destination.ofUser(options.text(Option.OUTPUT), out);
        }
        return options.isGrading() ? null : otherwise != null && scene.outputPlace().isEmpty() ? otherwise
                : Destination.ofScene(scene.scene().output(), scene.outputPlace(), out);
    }

    /** @throws UsageException if one of the files is taken */
    void claim(Places places) throws UsageException, IOException {
        places.read(input.path(), "the scene");
        places.write(picture(), "the picture of " + input.name());
        places.read(reference, "the reference");
        places.write(difference, "the difference picture of " + input.name());
    }

    private Path picture() {
        return destination == null ? null : destination.file();
    }

    /** What a picture of this size is compared with; null if with none. */
    Reference readReference(int width, int height, Options options) throws IOException {
        return reference == null ? null
                : Reference.read(reference, width, height, options.whole(Option.TOLERANCE, 0), difference);
    }

    /** Sees to it that rendering is not in vain. */
    void require() throws IOException {
        for (Path file : Arrays.asList(picture(), difference)) {
            if (file != null) {
                OutputFile.require(file);
            }
        }
    }

    /** Whether words on standard output would get into the picture. */
    boolean isPictureOnStandardOutput() {
        return destination != null && destination.file() == null;
    }

    Image newImage(int width, int height) throws IOException {
        try {
            return new Image(width, height);
        } catch (IllegalArgumentException | OutOfMemoryError e) {
            boolean isOurs = e instanceof IllegalArgumentException;
            throw new IOException("a picture of " + width + "x" + height + " pixels is too large: it needs "
                    + (Image.bytes(width, height) >> 20) + " MB, and " + (isOurs ? "2047 MB are the most"
                    : "Java may use " + (Runtime.getRuntime().maxMemory() >> 20) + " MB") + "; --region renders a part of it"
                    + (isOurs ? "" : ", and 'java -Xmx...m -jar ...' allows more"), e);
        }
    }
}
