package raytracer.cli;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.util.Map;
import raytracer.console.ExitStatus;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Stopwatch;
import raytracer.console.Terminal;
import raytracer.files.Destination;
import raytracer.files.Places;
import raytracer.files.Reason;
import raytracer.files.Reference;
import raytracer.files.UsageException;
import raytracer.image.PictureFile;
import raytracer.parser.Declarations;
import raytracer.parser.Diagnostic;
import raytracer.parser.ParsedScene;
import raytracer.parser.SceneException;
import raytracer.parser.SceneParser;
import raytracer.scene.Scene;

/** One scene of the command line and all that is asked for it; whatever goes wrong becomes one message and a status. */
final class Job {

    private final Input input;
    private final Options options;
    private final Terminal terminal;

    /** Why the scene cannot be read, until the job is run. */
    private Throwable failure;

    private ParsedScene parsed;
    private double parseMillis;
    private Outputs outputs;
    private Map<String, Object> figures;

    Job(Input input, Options options, Terminal terminal) {
        this.input = input;
        this.options = options;
        this.terminal = terminal;
        figures = Stats.head(input.name());
    }

    /**
     * Reads the scene, and claims the files that will be read and written; what is wrong with it shows when the job is run.
     *
     * @param otherwise where the picture goes if the scene names no output; null for the usual place
     * @throws UsageException if a file is taken
     */
    void prepare(Places places, Destination otherwise) throws UsageException {
        try {
            Stopwatch parsing = new Stopwatch();
            parsed = options.has(Option.EXPLAIN) || options.has(Option.COMPARE) && input.isPicture() ? null : input.parse();
            parseMillis = parsing.millis();
            outputs = Outputs.of(options, input, parsed, otherwise, terminal);
        } catch (IOException | SceneException | UsageException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
            failure = e;
            return;
        }
        try {
            if (!options.has(Option.CHECK) && !options.has(Option.CHART) && !options.has(Option.EXPLAIN)) {
                outputs.claim(places);
            }
        } catch (IOException e) {
            failure = e;
        }
    }

    /** Where the picture goes; null if it does not, or the scene cannot be read. */
    Destination destination() {
        return outputs == null ? null : outputs.destination();
    }

    /** What is known of it so far. */
    Map<String, Object> figures() {
        return figures;
    }

    /** Does the job; returns the exit status. */
    int run() {
        try {
            return failure != null ? fail(failure)
                    : options.has(Option.EXPLAIN) ? explain() : parsed == null ? comparePicture() : render();
        } catch (SceneException | UsageException | IOException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
            return fail(e);
        } finally {
            parsed = null;
        }
    }

    private int fail(Throwable e) {
        if (e instanceof SceneException scene) {
            scene.errors().forEach(error -> terminal.tell(error.toString()));
            if (!scene.rest().isEmpty()) {
                terminal.tell(input.name() + ": " + scene.rest());
            }
            return grade(ExitStatus.BAD_INPUT, "not read: " + Stats.counted(scene.count(), "error"));
        }
        String place = e instanceof UsageException usage ? usage.place() : "", reason = reason(e);
        terminal.tell(input.name() + place + ": " + reason);
        return grade(e instanceof UsageException ? ExitStatus.BAD_INPUT : ExitStatus.FAILED,
                options.isGrading() ? "not compared: " + reason : reason);
    }

    /** Where many are graded, each has its line, also one that fails. */
    private int grade(int status, String words) {
        figures.put("failed", words);
        if (options.isGrading()) {
            terminal.answer(input.name() + ": " + words);
        }
        return status;
    }

    private String reason(Throwable e) {
        // Whole numbers overflow only where they are sizes of arrays.
        if (e instanceof OutOfMemoryError || "integer overflow".equals(e.getMessage())) {
            return String.valueOf(e.getMessage()).contains("thread") ? "the system starts no more threads: --threads N uses fewer"
                    : "not enough memory: the scene and its picture need more than the "
                            + (Runtime.getRuntime().maxMemory() >> 20) + " MB that Java may use;"
                            + " 'java -Xmx4g -jar ...' allows 4 GB";
        }
        if (e instanceof RuntimeException || e instanceof StackOverflowError) {
            return "a fault in raytracer, please report it"
                    + (options.has(Option.VERBOSE) ? ": " + stackTrace(e) : " with what --verbose says: " + e);
        }
        return e.getMessage();
    }

    private static String stackTrace(Throwable e) {
        StringWriter trace = new StringWriter();
        e.printStackTrace(new PrintWriter(trace));
        return trace.toString();
    }

    private int explain() throws SceneException, UsageException, IOException {
        byte[] text = input.read();
        Scene scene = options.override(SceneParser.parse(input.name(), new ByteArrayInputStream(text)).scene());
        int[] pixel = options.pixel(scene.width(), scene.height());
        new Explaining(input.name(), Declarations.of(text), scene).explain(pixel[0], pixel[1])
                .forEach(terminal::answer);
        return ExitStatus.DONE;
    }

    private int render() throws UsageException, IOException {
        for (Diagnostic warning : parsed.warnings()) {
            terminal.tell(warning.toString());
        }
        Scene scene = options.override(parsed.scene());
        Stats stats = new Stats();
        stats.parseMillis = parseMillis;
        Rendering rendering = new Rendering(options, scene, outputs, stats, terminal);
        if (options.has(Option.CHECK)) {
            if (options.has(Option.VERBOSE)) {
                terminal.tell(input.name() + ": " + scene.width() + "x" + scene.height() + " " + outputs.destination()
                        + ", " + Stats.inWords(scene));
            }
            return ExitStatus.DONE;
        }
        if (options.has(Option.CHART)) {
            return new ChartJob(scene, options, terminal).run();
        }
        outputs.require();
        int status = rendering.run(parsed);
        figures = rendering.figures();
        return status;
    }

    private int comparePicture() throws IOException {
        outputs.require();
        try (InputStream in = Files.newInputStream(input.path()); PictureFile picture = PictureFile.open(in)) {
            figures.put("width", picture.width());
            figures.put("height", picture.height());
            Reference.Verdict verdict = outputs.readReference(picture.width(), picture.height(), options)
                    .compare(picture.read());
            figures.put("compare", Stats.compared(outputs.reference(), verdict));
            return Comparing.tell(verdict, options, outputs, terminal);
        } catch (IOException e) {
            throw new IOException("cannot read the picture: " + Reason.of(e), e);
        }
    }
}
