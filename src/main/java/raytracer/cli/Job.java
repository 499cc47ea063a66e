package raytracer.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.scene.Scene;
import raytracer.text.Diagnostic;
import raytracer.text.ParsedScene;
import raytracer.text.SceneException;
import raytracer.text.SceneParser;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/** One scene file, from reading it to its picture; whatever goes wrong becomes one message and a status. */
final class Job {

    private final String name;
    private final String file;
    private final Options options;
    private final PrintStream out;
    private final PrintStream err;

    Job(String file, Options options, PrintStream out, PrintStream err) {
        this.file = file;
        this.options = options;
        this.out = out;
        this.err = err;
        name = file.equals(Options.STANDARD) ? "<stdin>" : file;
    }

    /** Does the job; returns the exit status. */
    int run() {
        try {
            return parseAndRender();
        } catch (SceneException e) {
            e.errors().forEach(err::println);
            if (e.unlisted() > 0) {
                err.println(name + ": " + e.unlisted() + (e.unlisted() == 1 ? " more error" : " more errors"));
            }
            return Main.BAD_INPUT;
        } catch (UsageException e) {
            return fail(Main.BAD_INPUT, e.getMessage());
        } catch (IOException e) {
            return fail(Main.FAILED, e.getMessage());
        } catch (OutOfMemoryError e) {
            return fail(Main.FAILED, "not enough memory: the scene and its picture need more than the "
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MB that Java may use;"
                    + " 'java -Xmx4g -jar ...' allows 4 GB");
        } catch (RuntimeException | StackOverflowError e) {
            return fail(Main.FAILED, "a fault in raytracer, please report it: " + e);
        }
    }

    private int fail(int status, String message) {
        err.println(name + ": " + message);
        return status;
    }

    private int parseAndRender() throws SceneException, UsageException, IOException {
        Stopwatch whole = new Stopwatch();
        ParsedScene parsed = parse();
        Stats stats = new Stats(name, options.threads());
        stats.parseMillis = whole.millis();
        for (Diagnostic warning : parsed.warnings()) {
            err.println(warning);
        }
        Scene scene = overridden(parsed.scene());
        Region region = region(scene);
        Destination destination = Destination.of(options, scene, out);
        if (options.check()) {
            return Main.DONE;
        }
        if (options.chart() != null) {
            return new ChartJob(scene, options, out, err).run();
        }
        destination.requireFolder();
        Reference reference = options.reference() == null ? null
                : Reference.read(options.reference(), options.tolerance(), region);
        Picture picture = options.repeat() > 1 || reference != null
                ? Picture.Whole.of(region.width(), region.height())
                : new Picture.Streamed(region.width(), region.height(), destination);
        picture.during(() -> render(scene, region, picture, stats));
        Stopwatch writing = new Stopwatch();
        picture.write(destination);
        stats.writeMillis = writing.millis();
        if (options.stats() != null) {
            writeStats(stats, scene);
        }
        if (picture.undefinedPixels() > 0) {
            return fail(Main.FAILED, "a fault in raytracer, please report it: " + picture.undefinedPixels()
                    + " pixels have no colour");
        }
        if (options.verbose()) {
            err.print(stats.timesInWords());
        }
        if (!options.quiet()) {
            err.println(destination + " " + region.width() + "x" + region.height() + " in "
                    + tenths(whole.millis() / 1e3) + " s, " + tenths(stats.rays.total() / 1e6) + " Mrays");
        }
        if (reference == null) {
            return Main.DONE;
        }
        // Standard output may hold the picture: then words about it go elsewhere.
        return reference.compare(((Picture.Whole) picture).image().toBufferedImage(), destination,
                destination.file() == null ? err : out);
    }

    /** With one decimal; the library's formatter would take longer to load than a small picture to render. */
    private static String tenths(double value) {
        long tenths = Math.round(10 * value);
        return tenths / 10 + "." + tenths % 10;
    }

    private ParsedScene parse() throws SceneException, IOException {
        if (Files.isDirectory(Reason.path(file))) {
            throw new IOException("expected a scene file, found a directory");
        }
        try {
            if (file.equals(Options.STANDARD)) {
                return SceneParser.parse(name, System.in);
            }
            try (InputStream in = Files.newInputStream(Reason.path(file))) {
                return SceneParser.parse(name, in);
            }
        } catch (IOException e) {
            throw new IOException("cannot read the scene: " + Reason.of(e), e);
        }
    }

    private Scene overridden(Scene scene) {
        Scene sized = options.width() > 0 ? scene.withSize(options.width(), options.height()) : scene;
        return options.maxDepth() > 0 ? sized.withMaxDepth(options.maxDepth()) : sized;
    }

    private Region region(Scene scene) throws UsageException {
        Region region = options.region();
        if (region == null) {
            return Region.whole(scene.width(), scene.height());
        }
        long right = (long) region.x() + region.width(), bottom = (long) region.y() + region.height();
        if (right > scene.width() || bottom > scene.height()) {
            throw new UsageException("expected --region to be inside the picture of " + scene.width() + "x"
                    + scene.height() + ", found columns " + region.x() + " to " + (right - 1) + " and rows "
                    + region.y() + " to " + (bottom - 1));
        }
        return region;
    }

    private RayCounts render(Scene scene, Region region, Picture picture, Stats stats) {
        Stopwatch building = new Stopwatch();
        Tracer tracer = Tracer.compile(scene, options.threads());
        stats.buildMillis = building.millis();
        if (options.verbose()) {
            err.print(stats.sceneInWords(scene, tracer));
        }
        for (int i = 0; i < options.repeat(); i++) {
            Stopwatch rendering = new Stopwatch();
            Renderer renderer = new Renderer(tracer, options.sampling(), options.threads(), region, picture.sink());
            stats.rays = ProgressBar.during(renderer::render, err, options.quiet(), renderer::progress);
            stats.renderMillis.add(rendering.millis());
        }
        return stats.rays;
    }

    private void writeStats(Stats stats, Scene scene) throws IOException {
        try {
            Files.writeString(Reason.path(options.stats()), stats.json(scene));
        } catch (IOException e) {
            throw new IOException("cannot write " + options.stats() + ": " + Reason.of(e), e);
        }
    }
}
