package raytracer.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import raytracer.console.ExitStatus;
import raytracer.console.Json;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Destination;
import raytracer.files.OutputFile;
import raytracer.files.Places;
import raytracer.files.Reason;
import raytracer.files.UsageException;
import raytracer.image.PngFile;

/** The command line. Only this package prints, and only here does the program exit. */
public final class Main {

    private Main() { }

    public static void main(String[] args) {
        Locale.setDefault(Locale.ROOT);
        System.setProperty("java.awt.headless", "true");
        System.exit(run(args, System.out, System.err));
    }

    /** Does what the arguments say; returns the exit status. */
    static int run(String[] args, PrintStream out, PrintStream err) {
        Terminal terminal = new Terminal(out, err);
        try {
            Options options = Options.parse(args);
            if (options.has(Option.HELP)) {
                out.print(Option.help());
                return ExitStatus.DONE;
            }
            if (options.has(Option.VERSION)) {
                out.println("raytracer " + Stats.version());
                return ExitStatus.DONE;
            }
            if (!options.has(Option.CHECK) && !options.has(Option.CHART) && !options.has(Option.EXPLAIN)) {
                PngFile.prepare();
            }
            return options.has(Option.WATCH) ? new Watching(options, terminal).run() : run(options, terminal);
        } catch (UsageException e) {
            terminal.tell("raytracer: " + e.getMessage());
            return ExitStatus.BAD_INPUT;
        } catch (IOException e) {
            terminal.tell("raytracer: " + e.getMessage());
            return ExitStatus.FAILED;
        } catch (NoClassDefFoundError e) {
            terminal.tell("raytracer: this Java has no module java.desktop, which reads and writes pictures: use one that has");
            return ExitStatus.FAILED;
        }
    }

    /** Reads all scenes first, so that nothing is rendered if one job would replace what another reads or writes. */
    private static int run(Options options, Terminal terminal) throws UsageException, IOException {
        Places places = new Places();
        String stats = options.text(Option.STATS);
        Path statsFile = stats == null || stats.equals(Destination.STANDARD) ? null : Reason.path(stats);
        places.write(statsFile, "the statistics");
        if (statsFile != null) {
            OutputFile.require(statsFile);
        }
        List<Job> jobs = new ArrayList<>();
        for (String scene : options.scenes()) {
            jobs.add(new Job(new Input(scene), options, terminal));
            jobs.get(jobs.size() - 1).prepare(places, null);
        }
        int[] count = new int[ExitStatus.DIFFERS + 1];
        List<Map<String, Object>> figures = new ArrayList<>();
        for (Job job : jobs) {
            count[job.run()]++;
            figures.add(job.figures());
        }
        if (options.isGrading()) {
            terminal.answer(jobs.size() + " compared: " + count[ExitStatus.DONE] + " as they should be, "
                    + count[ExitStatus.DIFFERS] + " different, "
                    + (count[ExitStatus.FAILED] + count[ExitStatus.BAD_INPUT]) + " failed");
        }
        if (stats != null) {
            String json = jobs.size() == 1 ? Json.lines(figures.get(0)) : Json.of(figures).replace("}, {", "},\n{") + "\n";
            if (statsFile == null) {
                terminal.out().print(json);
            } else {
                OutputFile.write(statsFile, json);
            }
        }
        return IntStream.of(ExitStatus.DIFFERS, ExitStatus.BAD_INPUT, ExitStatus.FAILED).filter(status -> count[status] > 0)
                .findFirst().orElse(ExitStatus.DONE);
    }
}
