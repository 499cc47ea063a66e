package raytracer.cli;

import java.io.PrintStream;
import java.util.Locale;

/** The command line. Only this package prints, and only here does the program exit. */
public final class Main {

    /** All went well. */
    static final int DONE = 0;

    /** Something failed that is not the user's text: no memory, a full disk, an unreadable file. */
    static final int FAILED = 1;

    /** The command line or a scene is wrong. */
    static final int BAD_INPUT = 2;

    private static final String HELP = """
            usage: raytracer [options] SCENE...
            Renders scene files to PNG pictures.

              -o, --output FILE  write here instead of the scene's 'output' (one scene only)
                  --size WxH     override the scene's size
                  --maxdepth N   override the scene's maxdepth
                  --threads N    use N threads instead of one per core
                  --quiet        no progress and no summary; errors and warnings stay
                  --repeat N     render N times in this process, write once
                  --stats FILE   write figures as JSON (one scene only)
                  --check        parse and validate only, write nothing
              -h, --help         this text
                  --version      the version

            exit status: 0 done, 2 bad usage or bad scene, 1 anything else
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
            err.println("raytracer: " + e.getMessage());
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
        int status = DONE;
        for (String scene : options.scenes()) {
            status = Math.max(status, new Job(scene, options, err).run());
        }
        return status;
    }
}
