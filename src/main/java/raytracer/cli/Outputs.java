package raytracer.cli;

import java.io.IOException;
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
 * @param destination of the picture; null if none is rendered
 * @param reference   what the picture is compared with; null if with none
 * @param difference  where a picture of the differences goes; null if nowhere
 * @param stats       where figures go; null if nowhere
 */
record Outputs(Input input, Destination destination, Path reference, Path difference, Path stats) {

    /** @param scene null if the input is a picture */
    static Outputs of(Options options, Input input, ParsedScene scene, Terminal terminal)
            throws UsageException, IOException {
        Destination destination = scene == null ? null
                : options.has(Option.OUTPUT) ? Destination.ofUser(options.text(Option.OUTPUT), terminal.out())
                : Destination.ofScene(scene.scene().output(), scene.outputPlace(), terminal.out());
        Path reference = options.has(Option.COMPARE) ? Reference.of(options.text(Option.COMPARE), input.path()) : null;
        Path difference = reference == null ? null : options.has(Option.DIFF) ? Reason.path(options.text(Option.DIFF))
                : destination != null ? destination.ofDifferences() : Destination.ofDifferences(input.path());
        Path stats = options.has(Option.STATS) ? Reason.path(options.text(Option.STATS)) : null;
        return new Outputs(input, destination, reference, difference, stats);
    }

    /** @throws UsageException if one of the files is taken */
    void claim(Places places) throws UsageException, IOException {
        places.read(input.path(), "the scene");
        places.write(picture(), "the picture of " + input.name());
        places.read(reference, "the reference");
        places.write(difference, "the difference picture of " + input.name());
        places.write(stats, "the statistics");
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
        for (Path file : Arrays.asList(picture(), difference, stats)) {
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
            throw new IOException("a picture of " + width + "x" + height + " pixels is too large: it needs "
                    + (Image.bytes(width, height) >> 20) + " MB of at most 2047, and Java may use "
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MB; --region renders a part of it, and"
                    + " 'java -Xmx...m -jar ...' allows more", e);
        }
    }

    void writeStats(String json) throws IOException {
        if (stats != null) {
            OutputFile.write(stats, json);
        }
    }
}
