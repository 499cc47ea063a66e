package raytracer.cli;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import raytracer.image.PictureFile;
import raytracer.parser.Diagnostic;
import raytracer.parser.ParsedScene;
import raytracer.parser.SceneException;
import raytracer.parser.SceneParser;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.scene.Scene;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/** One scene file, from reading it to its picture; whatever goes wrong becomes one message and a status. */
final class Job {

    private final String name;
    private final String file;
    private final Options options;
    private final Places places;
    private final Terminal terminal;
    private boolean claimed;

    Job(String file, Options options, Places places, Terminal terminal) {
        this.file = file;
        this.options = options;
        this.places = places;
        this.terminal = terminal;
        name = file.equals(Options.STANDARD) ? "<stdin>" : file;
    }

    /**
     * Claims the files that will be read and written, for which the scene must be read; what else is wrong with it
     * shows when it is run.
     *
     * @throws UsageException if one is taken
     */
    void claim() throws UsageException {
        Destination destination = null;
        try {
            if (!isPicture()) {
                destination = Destination.of(options, parse(), terminal.out());
            }
        } catch (IOException | SceneException | UsageException e) {
            return;
        }
        try {
            claim(destination);
        } catch (IOException e) {
            // As above.
        }
    }

    /** Does the job; returns the exit status. */
    int run() {
        try {
            return isPicture() ? comparePicture() : parseAndRender();
        } catch (SceneException e) {
            e.errors().forEach(error -> terminal.tell(error.toString()));
            if (e.unlisted() > 0) {
                terminal.tell(name + ": " + e.unlisted() + (e.unlisted() == 1 ? " more error" : " more errors")
                        + (e.isCutShort() ? "; the rest was not read" : ""));
            }
            return Main.BAD_INPUT;
        } catch (UsageException e) {
            return fail(Main.BAD_INPUT, e.place(), e.getMessage());
        } catch (IOException e) {
            return fail(Main.FAILED, e.getMessage());
        } catch (OutOfMemoryError e) {
            return fail(Main.FAILED, "not enough memory: the scene and its picture need more than the "
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MB that Java may use;"
                    + " 'java -Xmx4g -jar ...' allows 4 GB");
        } catch (RuntimeException | StackOverflowError e) {
            return fail(Main.FAILED, "a fault in raytracer, please report it"
                    + (options.verbose() ? ": " + stackTrace(e) : " with what --verbose says: " + e));
        }
    }

    private static String stackTrace(Throwable e) {
        StringWriter trace = new StringWriter();
        e.printStackTrace(new PrintWriter(trace));
        return trace.toString();
    }

    private int fail(int status, String message) {
        return fail(status, "", message);
    }

    private int fail(int status, String place, String message) {
        terminal.tell(name + place + ": " + message);
        return status;
    }

    private int parseAndRender() throws SceneException, UsageException, IOException {
        Stopwatch whole = new Stopwatch();
        ParsedScene parsed = parse();
        Stats stats = new Stats(name, options.threads());
        stats.parseMillis = whole.millis();
        for (Diagnostic warning : parsed.warnings()) {
            terminal.tell(warning.toString());
        }
        Scene scene = overridden(parsed.scene());
        Region region = region(scene);
        Destination destination = Destination.of(options, parsed, terminal.out());
        if (options.check()) {
            if (options.verbose()) {
                terminal.tell(name + ": " + scene.width() + "x" + scene.height() + " " + destination + ", "
                        + Stats.inWords(scene));
            }
            return Main.DONE;
        }
        if (options.chart() != null) {
            return new ChartJob(scene, options, places, terminal).run();
        }
        require(destination);
        Reference reference = reference(region.width(), region.height(), destination);
        Picture picture = options.repeat() > 1 || reference != null
                ? Picture.Whole.of(region.width(), region.height())
                : new Picture.Streamed(region.width(), region.height(), destination);
        picture.during(() -> render(scene, region, picture, stats));
        Stopwatch writing = new Stopwatch();
        picture.write(destination);
        stats.writeMillis = writing.millis();
        if (picture.undefinedPixels() > 0) {
            return fail(Main.FAILED, "a fault in raytracer, please report it: " + picture.undefinedPixels()
                    + " pixels have no colour");
        }
        tellHowItWent(scene, destination, region, stats, whole);
        if (picture.isBlack() && options.region() == null && !parsed.isKnownToBeBlack()) {
            terminal.tell(name + ": warning: the picture is black: " + BlackPicture.reason(parsed));
        }
        int status = reference == null ? Main.DONE
                : compare(reference, ((Picture.Whole) picture).image().toBufferedImage(), destination, stats);
        writeStats(stats.json(scene));
        return status;
    }

    /** @param destination null if nothing is rendered */
    private void claim(Destination destination) throws UsageException, IOException {
        if (claimed) {
            return;
        }
        claimed = true;
        places.read(Reason.path(file), "the scene");
        if (destination != null && destination.file() != null) {
            places.write(destination.file(), "the picture of " + name);
        }
        if (options.reference() != null) {
            places.read(Reference.of(options.reference(), Reason.path(file)), "the reference");
            if (difference(destination) != null) {
                places.write(difference(destination), "the difference picture of " + name);
            }
        }
        if (options.stats() != null) {
            places.write(Reason.path(options.stats()), "the statistics");
        }
    }

    /** Where a picture of differences may go; null if nowhere. */
    private Path difference(Destination destination) throws IOException {
        return options.difference() != null ? Reason.path(options.difference())
                : destination != null ? destination.ofDifferences() : Destination.ofDifferences(Reason.path(file));
    }

    /** Sees to it that rendering is not in vain. */
    private void require(Destination destination) throws UsageException, IOException {
        claim(destination);
        if (destination != null && destination.file() != null) {
            OutputFile.require(destination.file());
        }
        if (options.reference() != null && difference(destination) != null) {
            OutputFile.require(difference(destination));
        }
        if (options.stats() != null) {
            OutputFile.require(Reason.path(options.stats()));
        }
    }

    private Reference reference(int width, int height, Destination destination) throws IOException {
        return options.reference() == null ? null : Reference.read(Reference.of(options.reference(), Reason.path(file)),
                width, height, options.tolerance(), difference(destination));
    }

    private int compare(Reference reference, BufferedImage actual, Destination destination, Stats stats)
            throws IOException {
        Reference.Verdict verdict = reference.compare(actual);
        stats.compared(reference, verdict);
        String words = (options.scenes().size() > 1 ? name + ": " : "") + verdict.words();
        // Standard output may hold the picture: then words about it go elsewhere.
        if (destination != null && destination.file() == null) {
            terminal.tell(words);
        } else {
            terminal.answer(words);
        }
        return verdict.status();
    }

    /** Whether the scene is no scene but a picture, which is only to be compared. */
    private boolean isPicture() throws IOException {
        if (options.reference() == null || file.equals(Options.STANDARD) || !Files.isRegularFile(Reason.path(file))) {
            return false;
        }
        try (InputStream in = Files.newInputStream(Reason.path(file))) {
            return PictureFile.isPng(in.readNBytes(8));
        }
    }

    private int comparePicture() throws UsageException, IOException {
        require(null);
        Path subject = Reason.path(file);
        try (InputStream in = Files.newInputStream(subject); PictureFile picture = PictureFile.open(in)) {
            Reference reference = reference(picture.width(), picture.height(), null);
            Stats stats = new Stats(name, options.threads());
            int status = compare(reference, picture.read(), null, stats);
            writeStats(stats.json(picture.width(), picture.height()));
            return status;
        }
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
            throw new IOException("cannot read the scene: " + Reason.of(e) + Reason.ofEncoding(file), e);
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
            terminal.tell(stats.sceneInWords(scene, tracer));
        }
        for (int i = 0; i < options.repeat(); i++) {
            Stopwatch rendering = new Stopwatch();
            Renderer renderer = new Renderer(tracer, options.sampling(), options.threads(), region, picture.sink());
            stats.rays = ProgressBar.during(renderer::render, terminal.err(), options.quiet(), renderer::progress);
            stats.renderMillis.add(rendering.millis());
        }
        return stats.rays;
    }

    private void tellHowItWent(Scene scene, Destination destination, Region region, Stats stats, Stopwatch whole) {
        if (options.verbose()) {
            terminal.tell(stats.timesInWords());
        }
        if (!options.quiet()) {
            terminal.tell(destination + " " + region.width() + "x" + region.height() + " in "
                    + Stats.tenths(whole.millis() / 1e3) + " s, " + stats.raysInWords());
        }
    }

    private void writeStats(String json) throws IOException {
        if (options.stats() == null) {
            return;
        }
        try {
            OutputFile.write(Reason.path(options.stats()), out -> out.write(json.getBytes(StandardCharsets.UTF_8)));
        } catch (IOException e) {
            throw new IOException("cannot write " + options.stats() + ": " + Reason.of(e), e);
        }
    }
}
