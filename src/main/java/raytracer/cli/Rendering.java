package raytracer.cli;

import java.io.IOException;
import java.util.Map;
import raytracer.console.ExitStatus;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.ProgressBar;
import raytracer.console.Stopwatch;
import raytracer.console.Terminal;
import raytracer.files.Reference;
import raytracer.files.UsageException;
import raytracer.image.Image;
import raytracer.parser.ParsedScene;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/** Renders a scene into its file, compares it if that is asked for, and says how it went. */
final class Rendering {

    private final Options options;
    private final Scene scene;
    private final Outputs outputs;
    private final Stats stats;
    private final Terminal terminal;
    private final Region region;
    private final Sampling sampling;
    private Map<String, Object> figures;

    Rendering(Options options, Scene scene, Outputs outputs, Stats stats, Terminal terminal) throws UsageException {
        this.options = options;
        this.scene = scene;
        this.outputs = outputs;
        this.stats = stats;
        this.terminal = terminal;
        region = options.region(scene.width(), scene.height());
        sampling = options.sampling();
        int side = Math.max(scene.width(), scene.height());
        if (sampling instanceof Sampling.Grid grid && (long) grid.n() * side > Integer.MAX_VALUE) {
            throw new UsageException("expected --samples N to be at most " + Integer.MAX_VALUE / side
                    + " for a picture of " + scene.width() + "x" + scene.height() + ", found " + grid.n());
        }
    }

    /** Returns the exit status. */
    int run(ParsedScene parsed) throws IOException {
        Reference reference = outputs.readReference(region.width(), region.height(), options);
        Image image = outputs.newImage(region.width(), region.height());
        Stopwatch building = new Stopwatch();
        Tracer tracer = Tracer.compile(scene);
        stats.buildMillis = building.millis();
        trace(tracer, image);
        if (image.undefinedPixels() > 0) {
            terminal.tell(outputs.input().name() + ": a fault in raytracer, please report it: "
                    + image.undefinedPixels() + " pixels have no colour");
            return ExitStatus.FAILED;
        }
        Stopwatch writing = new Stopwatch();
        if (outputs.destination() != null) {
            outputs.destination().write(image.toBufferedImage());
        }
        stats.writeMillis = writing.millis();
        figures = stats.figures(outputs.input().name(), scene, options.threads());
        tellHowItWent();
        String advice = options.has(Option.REGION) ? null
                : PictureAdvice.of(image, image.cutPixels() / options.whole(Option.REPEAT, 1), parsed.colours(), tracer,
                        options.threads());
        if (advice != null) {
            terminal.tell(outputs.input().name() + ": warning: " + advice);
        }
        Reference.Verdict verdict = reference == null ? null : reference.compare(image.toBufferedImage());
        int status = verdict == null ? ExitStatus.DONE : Comparing.tell(verdict, options, outputs, terminal);
        if (verdict != null) {
            figures.put("compare", Stats.compared(outputs.reference(), verdict));
        }
        return status;
    }

    /** Of what was rendered. */
    Map<String, Object> figures() {
        return figures;
    }

    private void trace(Tracer tracer, Image image) {
        if (options.has(Option.VERBOSE)) {
            terminal.tell(stats.sceneInWords(scene, tracer));
        }
        for (int i = 0; i < options.whole(Option.REPEAT, 1); i++) {
            Stopwatch rendering = new Stopwatch();
            Renderer renderer = new Renderer(tracer, sampling, options.threads(), region, image);
            stats.rays = ProgressBar.during(
                    renderer::render, terminal.err(), options.has(Option.QUIET), renderer::progress);
            stats.samples = renderer.samples();
            stats.renderMillis.add(rendering.millis());
        }
    }

    private void tellHowItWent() {
        if (options.has(Option.VERBOSE)) {
            terminal.tell(stats.timesInWords());
        }
        if (!options.has(Option.QUIET) && outputs.destination() != null) {
            terminal.tell(outputs.destination() + " " + region.width() + "x" + region.height() + " in "
                    + Stats.tenths(stats.whole.millis() / 1e3) + " s, " + stats.raysInWords());
        }
    }
}
