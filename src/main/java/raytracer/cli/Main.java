package raytracer.cli;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

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

    private static final String HELP = """
            usage: raytracer [options] SCENE...       SCENE may be - for standard input
              -o, --output FILE     write here, not to the scene's 'output'; - for stdout
                  --size WxH        override the scene's size
                  --maxdepth N      override the scene's maxdepth
                  --samples N       N x N samples a pixel, 1 to 64; 1 is the reference
                  --samples auto:E  as many as an error of E takes; 1/255 if left out
                  --region X,Y,W,H  render only this part of the picture
                  --threads N       use N threads instead of one per core
                  --compare FILE    compare with this picture; SCENE may be a picture too
                  --compare FOLDER  compare each SCENE with NAME.png in there
                  --diff FILE       show differences here; else beside, in NAME-diff.png
                  --tolerance N     by how much components may differ, 0 to 255
                  --chart FILE.svg  chart time against error for this scene; no picture
                  --chart-seconds N how long to measure for it, about (60)
                  --quiet           no progress and no summary; errors and warnings stay
                  --verbose         tell what was read and built, and how fast it went
                  --repeat N        render N times in this process, write once
                  --stats FILE      write figures as JSON
                  --check           parse and validate only, write nothing
              -h, --help; --version this text; the version

            exit status: 0 done, 1 failed, 2 bad usage or scene, 3 pictures differ
            """;

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
        if (options.help()) {
            out.print(HELP);
            return DONE;
        }
        if (options.version()) {
            String version = Main.class.getPackage().getImplementationVersion();
            out.println("raytracer " + (version == null ? "(development)" : version));
            return DONE;
        }
        if (!options.check() && options.chart() == null) {
            Picture.loadEncoder();
        }
        return run(options, new Terminal(out, err));
    }

    private static int run(Options options, Terminal terminal) {
        Places places = new Places();
        List<Job> jobs = new ArrayList<>();
        for (String scene : options.scenes()) {
            jobs.add(new Job(scene, options, places, terminal));
        }
        try {
            if (jobs.size() > 1 && !options.check()) {
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
