package raytracer.cli;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Places;
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
    private final Places places;
    private final Terminal terminal;
    private boolean isClaimed;

    Job(Input input, Options options, Places places, Terminal terminal) {
        this.input = input;
        this.options = options;
        this.places = places;
        this.terminal = terminal;
    }

    /**
     * Claims the files that will be read and written, for which the scene must be read; what else is wrong with it
     * shows when it is run.
     *
     * @throws UsageException if one is taken
     */
    void claim() throws UsageException {
        Outputs outputs;
        try {
            outputs = Outputs.of(options, input, isComparison() ? null : input.parse(), terminal);
        } catch (IOException | SceneException | UsageException e) {
            return;
        }
        try {
            claim(outputs);
        } catch (IOException e) {
            // As above.
        }
    }

    private void claim(Outputs outputs) throws UsageException, IOException {
        if (!isClaimed) {
            isClaimed = true;
            outputs.claim(places);
        }
    }

    /** Does the job; returns the exit status. */
    int run() {
        try {
            return options.has(Option.EXPLAIN) ? explain() : isComparison() ? comparePicture() : parseAndRender();
        } catch (SceneException e) {
            e.errors().forEach(error -> terminal.tell(error.toString()));
            if (!e.rest().isEmpty()) {
                terminal.tell(input.name() + ": " + e.rest());
            }
            return Main.BAD_INPUT;
        } catch (UsageException e) {
            return fail(Main.BAD_INPUT, e.place(), e.getMessage());
        } catch (IOException e) {
            return fail(Main.FAILED, "", e.getMessage());
        } catch (OutOfMemoryError e) {
            return fail(Main.FAILED, "", "not enough memory: the scene and its picture need more than the "
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MB that Java may use;"
                    + " 'java -Xmx4g -jar ...' allows 4 GB");
        } catch (RuntimeException | StackOverflowError e) {
            return fail(Main.FAILED, "", "a fault in raytracer, please report it"
                    + (options.has(Option.VERBOSE) ? ": " + stackTrace(e) : " with what --verbose says: " + e));
        }
    }

    private static String stackTrace(Throwable e) {
        StringWriter trace = new StringWriter();
        e.printStackTrace(new PrintWriter(trace));
        return trace.toString();
    }

    private int fail(int status, String place, String message) {
        terminal.tell(input.name() + place + ": " + message);
        return status;
    }

    private int explain() throws SceneException, UsageException, IOException {
        byte[] text = input.read();
        Scene scene = options.override(SceneParser.parse(input.name(), new ByteArrayInputStream(text)).scene());
        int[] pixel = options.pixel(scene.width(), scene.height());
        new Explaining(input.name(), Declarations.of(text), scene).explain(pixel[0], pixel[1])
                .forEach(terminal::answer);
        return Main.DONE;
    }

    private int parseAndRender() throws SceneException, UsageException, IOException {
        Stats stats = new Stats(input.name(), options.threads());
        ParsedScene parsed = input.parse();
        stats.parseMillis = stats.whole.millis();
        for (Diagnostic warning : parsed.warnings()) {
            terminal.tell(warning.toString());
        }
        Scene scene = options.override(parsed.scene());
        Outputs outputs = Outputs.of(options, input, parsed, terminal);
        Rendering rendering = new Rendering(options, scene, outputs, stats, terminal);
        if (options.has(Option.CHECK)) {
            if (options.has(Option.VERBOSE)) {
                terminal.tell(input.name() + ": " + scene.width() + "x" + scene.height() + " " + outputs.destination()
                        + ", " + Stats.inWords(scene));
            }
            return Main.DONE;
        }
        if (options.has(Option.CHART)) {
            return new ChartJob(scene, options, places, terminal).run();
        }
        claim(outputs);
        outputs.require();
        return rendering.run(parsed);
    }

    /** Whether the input is no scene but a picture, which is only to be compared. */
    private boolean isComparison() throws IOException {
        return options.has(Option.COMPARE) && input.isPicture();
    }

    private int comparePicture() throws UsageException, IOException {
        Outputs outputs = Outputs.of(options, input, null, terminal);
        claim(outputs);
        outputs.require();
        try (InputStream in = Files.newInputStream(input.path()); PictureFile picture = PictureFile.open(in)) {
            Reference.Verdict verdict = outputs.readReference(picture.width(), picture.height(), options)
                    .compare(picture.read());
            int status = Comparing.tell(verdict, options, outputs, terminal);
            outputs.writeStats(Stats.json(input.name(), outputs.reference(), verdict, picture.width(),
                    picture.height()));
            return status;
        }
    }
}
