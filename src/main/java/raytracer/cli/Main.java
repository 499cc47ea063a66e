package raytracer.cli;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Places;
import raytracer.files.UsageException;
import raytracer.image.PngFile;

/** The command line. Only this package prints, and only here does the program exit. */
public final class Main {

    /** All went well. */
    static final int DONE = 0;

    /** Something failed that is not the user's text: no memory, a full disk, an unreadable file. */
    static final int FAILED = 1;

    /** The command line or a scene is wrong. */
    static final int BAD_INPUT = 2;

    /** The picture is not the one it was compared with. */
    static final int DIFFERS = 3;

    private Main() { }

    public static void main(String[] args) {
        Locale.setDefault(Locale.ROOT);
        System.setProperty("java.awt.headless", "true");
        System.exit(run(args, System.out, System.err));
    }

    /** Does what the arguments say; returns the exit status. */
    static int run(String[] args, PrintStream out, PrintStream err) {
        Options options;
        try {
            options = Options.parse(args);
        } catch (UsageException e) {
            new Terminal(out, err).tell("raytracer: " + e.getMessage());
            return BAD_INPUT;
        }
        if (options.has(Option.HELP)) {
            out.print(Option.help());
            return DONE;
        }
        if (options.has(Option.VERSION)) {
            String version = Main.class.getPackage().getImplementationVersion();
            out.println("raytracer " + (version == null ? "(development)" : version));
            return DONE;
        }
        if (!options.has(Option.CHECK) && !options.has(Option.CHART) && !options.has(Option.EXPLAIN)) {
            PngFile.prepare();
        }
        Terminal terminal = new Terminal(out, err);
        return options.has(Option.WATCH) ? watch(options, terminal) : run(options, terminal);
    }

    /** Renders again and again, in this process: the second picture takes a fraction of the first one's time. */
    private static int watch(Options options, Terminal terminal) {
        List<Input> inputs = options.scenes().stream().map(Input::new).toList();
        if (inputs.stream().anyMatch(Input::isStandard)) {
            terminal.tell("raytracer: --watch goes with files, found standard input");
            return BAD_INPUT;
        }
        new Watching(inputs, input -> new Job(input, options, new Places(), terminal).run()).run();
        return DONE;
    }

    private static int run(Options options, Terminal terminal) {
        Places places = new Places();
        List<Job> jobs = new ArrayList<>();
        for (String scene : options.scenes()) {
            jobs.add(new Job(new Input(scene), options, places, terminal));
        }
        try {
            if (jobs.size() > 1 && !options.has(Option.CHECK)) {
                for (Job job : jobs) {
                    job.claim();
                }
            }
        } catch (UsageException e) {
            terminal.tell("raytracer: " + e.getMessage());
            return BAD_INPUT;
        }
        int status = DONE;
        for (Job job : jobs) {
            status = Math.max(status, job.run());
        }
        return status;
    }
}
