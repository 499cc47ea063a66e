package raytracer.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import raytracer.image.Image;
import raytracer.image.PngFile;
import raytracer.render.Renderer;
import raytracer.scene.Scene;
import raytracer.text.Diagnostic;
import raytracer.text.ParsedScene;
import raytracer.text.SceneException;
import raytracer.text.SceneParser;
import raytracer.tracer.Tracer;

/** One scene file, from reading it to its picture; whatever goes wrong becomes one message and a status. */
final class Job {

    private final String file;
    private final Options options;
    private final PrintStream err;

    Job(String file, Options options, PrintStream err) {
        this.file = file;
        this.options = options;
        this.err = err;
    }

    /** Does the job; returns the exit status. */
    int run() {
        try {
            return parseAndRender();
        } catch (SceneException e) {
            e.errors().forEach(err::println);
            if (e.unlisted() > 0) {
                err.println(file + ": " + e.unlisted() + (e.unlisted() == 1 ? " more error" : " more errors"));
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
        err.println(file + ": " + message);
        return status;
    }

    private int parseAndRender() throws SceneException, UsageException, IOException {
        Stopwatch whole = new Stopwatch();
        ParsedScene parsed = parse();
        Stats stats = new Stats(file, options.threads());
        stats.parseMillis = whole.millis();
        for (Diagnostic warning : parsed.warnings()) {
            err.println(warning);
        }
        Scene scene = overridden(parsed.scene());
        Path output = output(scene);
        if (options.check()) {
            return Main.DONE;
        }
        requireFolder(output);
        loadEncoder();
        Image image = newImage(scene);
        render(scene, image, stats);
        Stopwatch writing = new Stopwatch();
        write(image, output);
        stats.writeMillis = writing.millis();
        if (options.stats() != null) {
            writeStats(stats, scene);
        }
        if (image.undefinedPixels() > 0) {
            return fail(Main.FAILED, "a fault in raytracer, please report it: " + image.undefinedPixels()
                    + " pixels have no colour");
        }
        if (!options.quiet()) {
            err.printf("%s %dx%d in %.1f s, %.1f Mrays%n", output, scene.width(), scene.height(),
                    whole.millis() / 1e3, stats.rays.total() / 1e6);
        }
        return Main.DONE;
    }

    private ParsedScene parse() throws SceneException, IOException {
        if (Files.isDirectory(path(file))) {
            throw new IOException("expected a scene file, found a directory");
        }
        try (InputStream in = Files.newInputStream(path(file))) {
            return SceneParser.parse(file, in);
        } catch (IOException e) {
            throw new IOException("cannot read the scene: " + reason(e), e);
        }
    }

    private static Path path(String name) throws IOException {
        try {
            return Path.of(name);
        } catch (InvalidPathException e) {
            throw new IOException("not a file name: " + e.getReason(), e);
        }
    }

    private Scene overridden(Scene scene) {
        Scene sized = options.width() > 0 ? scene.withSize(options.width(), options.height()) : scene;
        return options.maxDepth() > 0 ? sized.withMaxDepth(options.maxDepth()) : sized;
    }

    /** Where the picture goes. A scene is somebody else's file: what it names stays in the working directory. */
    private Path output(Scene scene) throws UsageException, IOException {
        if (options.output() != null) {
            return path(options.output());
        }
        Path named = path(scene.output());
        for (Path step : named) {
            if (named.isAbsolute() || step.toString().equals("..")) {
                throw new UsageException("expected 'output' to be inside the working directory, found '"
                        + scene.output() + "'; -o FILE writes anywhere");
            }
        }
        return named;
    }

    private static void requireFolder(Path output) throws IOException {
        Path folder = output.toAbsolutePath().getParent();
        if (folder == null || Files.isDirectory(output)) {
            throw new IOException("cannot write " + output + ": it is a directory");
        }
        if (!Files.isDirectory(folder)) {
            throw new IOException("cannot write " + output + ": there is no directory " + folder);
        }
    }

    /** Lets the encoder load while the picture is rendered: a third of a second when a program has just started. */
    private static void loadEncoder() {
        Thread thread = new Thread(PngFile::prepare, "encoder");
        thread.setDaemon(true);
        // Whatever goes wrong there goes wrong again when the picture is written, and is told then.
        thread.setUncaughtExceptionHandler((failed, reason) -> { });
        thread.start();
    }

    private static Image newImage(Scene scene) throws IOException {
        long bytes = Image.bytes(scene.width(), scene.height());
        String what = "a picture of " + scene.width() + "x" + scene.height() + " pixels ";
        if (bytes > Image.mostBytes()) {
            throw new IOException(what + "is too large: PNG in Java ends at " + Image.mostBytes() / 3 + " pixels");
        }
        try {
            return new Image(scene.width(), scene.height());
        } catch (OutOfMemoryError e) {
            throw new IOException(what + "needs " + (bytes >> 20) + " MB of memory, and Java may use "
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MB; 'java -Xmx" + ((bytes >> 20) + 256)
                    + "m -jar ...' allows enough", e);
        }
    }

    private void render(Scene scene, Image image, Stats stats) {
        Stopwatch building = new Stopwatch();
        Tracer tracer = Tracer.compile(scene, options.threads());
        stats.buildMillis = building.millis();
        for (int i = 0; i < options.repeat(); i++) {
            Stopwatch rendering = new Stopwatch();
            Renderer renderer = new Renderer(tracer, options.threads(), image);
            stats.rays = ProgressBar.during(renderer::render, err, options.quiet(), renderer::progress);
            stats.renderMillis.add(rendering.millis());
        }
    }

    private static void write(Image image, Path output) throws IOException {
        try {
            PngFile.write(image, output);
        } catch (IOException e) {
            throw new IOException("cannot write " + output + ": " + reason(e), e);
        }
    }

    private void writeStats(Stats stats, Scene scene) throws IOException {
        try {
            Files.writeString(path(options.stats()), stats.json(scene));
        } catch (IOException e) {
            throw new IOException("cannot write " + options.stats() + ": " + reason(e), e);
        }
    }

    /** Why a file operation failed, in words; the library's messages for some are just the file's name. */
    private static String reason(IOException e) {
        if (e instanceof NoSuchFileException) {
            return "no such file or directory";
        }
        if (e instanceof AccessDeniedException) {
            return "permission denied";
        }
        if (e instanceof FileSystemException system && system.getReason() != null) {
            return system.getReason();
        }
        return e.getMessage() == null ? e.toString() : e.getMessage();
    }
}
