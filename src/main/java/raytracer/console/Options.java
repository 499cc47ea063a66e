package raytracer.console;

import java.io.File;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import raytracer.files.UsageException;
import raytracer.parser.SceneException;
import raytracer.parser.SceneParser;
import raytracer.render.Region;
import raytracer.render.Sampling;
import raytracer.scene.Camera;
import raytracer.scene.Scene;

/** What the command line asks for: once made, every value can be read. */
public final class Options {

    /** In place of a file's name. */
    private static final String STANDARD = "-";

    private static final int MAX_THREADS = 1024;
    private static final int MAX_SECONDS = 24 * 60 * 60;
    private static final int DEFAULT_SECONDS = 60;

    /** A number or a fraction. */
    private static final Pattern ERROR = Pattern.compile("auto:(\\d*\\.?\\d+)(?:/(\\d*\\.?\\d+))?");

    private final List<String> scenes = new ArrayList<>();
    private final Map<Option, String> values = new EnumMap<>(Option.class);

    /** Of the options whose values are whole numbers. */
    private final Map<Option, int[]> numbers = new EnumMap<>(Option.class);

    private Sampling sampling = Sampling.CENTRES;
    private Camera camera;

    public static Options parse(String... args) throws UsageException {
        Options options = new Options();
        options.read(List.of(args).iterator());
        if (!options.has(Option.HELP) && !options.has(Option.VERSION)) {
            options.readValues();
            options.requireScenes();
            options.requireSense();
        }
        return options;
    }

    private Options() { }

    private void read(Iterator<String> args) throws UsageException {
        while (args.hasNext()) {
            String arg = args.next();
            if (arg.equals("--")) {
                args.forEachRemaining(scenes::add);
            } else if (arg.startsWith("-") && arg.length() > 1) {
                int equals = arg.startsWith("--") ? arg.indexOf('=') : -1;
                String flag = equals < 0 ? arg : arg.substring(0, equals);
                put(Option.of(flag), flag, equals < 0 ? null : arg.substring(equals + 1), args);
            } else {
                scenes.add(arg);
            }
        }
    }

    private void put(Option option, String flag, String attached, Iterator<String> args) throws UsageException {
        if (!option.takesValue() && attached != null) {
            throw new UsageException(flag + " takes no value, found '" + attached + "'");
        }
        String value = attached != null ? attached : option.takesValue() && args.hasNext() ? args.next() : "";
        if (option.takesValue() && value.isEmpty()) {
            throw new UsageException("expected a value after " + flag + ", found none");
        }
        if (option.takesValue() && attached == null && Option.isFlag(value)) {
            throw new UsageException("expected a value after " + flag + ", found the option " + value);
        }
        values.put(option, value);
    }

    private void requireScenes() throws UsageException {
        if (scenes.isEmpty() || scenes.contains("")) {
            throw new UsageException("expected a scene file, found " + (scenes.isEmpty() ? "none; see --help" : "an empty name"));
        }
        if (scenes.size() > 1) {
            for (Option option : List.of(Option.DIFF, Option.CHART, Option.EXPLAIN)) {
                if (has(option)) {
                    throw new UsageException(option.flag() + " goes with one scene, found " + scenes.size());
                }
            }
            if (has(Option.OUTPUT) && !new File(text(Option.OUTPUT)).isDirectory()) {
                throw new UsageException("expected -o to name a folder that is there, for " + scenes.size()
                        + " scenes, found '" + text(Option.OUTPUT) + "'");
            }
        }
    }

    private void requireSense() throws UsageException {
        requireTogether(Option.TOLERANCE, Option.COMPARE);
        requireTogether(Option.DIFF, Option.COMPARE);
        requireTogether(Option.CHART_SECONDS, Option.CHART);
        requireWithout(Option.EXPLAIN, "it tells of a pixel's one sample, and renders no picture",
                Option.COMPARE, Option.REGION, Option.OUTPUT, Option.SAMPLES, Option.CHART, Option.STATS, Option.WATCH);
        requireWithout(Option.WATCH, "it renders again and again", Option.CHART, Option.COMPARE, Option.REPEAT,
                Option.CHECK, Option.STATS);
        requireWithout(Option.CHART, "it tries many settings in turns, and writes a chart in place of a picture",
                Option.COMPARE, Option.REGION, Option.OUTPUT, Option.SAMPLES, Option.REPEAT, Option.STATS);
        requireWithout(Option.CHECK, "it renders no picture", Option.COMPARE, Option.STATS, Option.CHART, Option.EXPLAIN);
        if (has(Option.CHART) && !text(Option.CHART).endsWith(".svg")) {
            throw new UsageException("expected the file of --chart to end in '.svg', found '" + text(Option.CHART) + "'");
        }
        if (STANDARD.equals(text(Option.STATS)) && STANDARD.equals(text(Option.OUTPUT))) {
            throw new UsageException("expected one of --output and --stats to be '-', found both");
        }
    }

    private void requireWithout(Option option, String reason, Option... others) throws UsageException {
        for (Option other : others) {
            if (has(option) && has(other)) {
                throw new UsageException(option.flag() + " goes without " + other.flag() + ": " + reason);
            }
        }
    }

    private void requireTogether(Option option, Option other) throws UsageException {
        if (has(option) && !has(other)) {
            throw new UsageException(option.flag() + " goes with " + other.flag() + ", found none");
        }
    }

    private void readValues() throws UsageException {
        readWhole(Option.MAXDEPTH, 1, Integer.MAX_VALUE);
        readWhole(Option.THREADS, 1, MAX_THREADS);
        readWhole(Option.REPEAT, 1, Integer.MAX_VALUE);
        readWhole(Option.TOLERANCE, 0, 255);
        readWhole(Option.CHART_SECONDS, 1, MAX_SECONDS);
        readWholes(Option.SIZE, "[xX]", "like 640x480", "width", "height");
        readWholes(Option.REGION, ",", "like 0,120,640,60: column, row, width and height of a part of the picture",
                "column", "row", "width", "height");
        readWholes(Option.EXPLAIN, ",", "like 100,85: column and row of a pixel", "column", "row");
        if (has(Option.CAMERA)) {
            camera = camera(text(Option.CAMERA));
        }
        if (has(Option.SAMPLES)) {
            sampling = sampling(text(Option.SAMPLES));
        }
    }

    /** As a scene's line has it. */
    private static Camera camera(String numbers) throws UsageException {
        try {
            return SceneParser.camera("--camera", numbers);
        } catch (SceneException e) {
            throw new UsageException(e.errors().get(0).toString());
        }
    }

    private void readWhole(Option option, int min, int max) throws UsageException {
        if (has(option)) {
            numbers.put(option, new int[] {whole(option.flag(), text(option), min, max)});
        }
    }

    /** @param names what its numbers are called: columns and rows count from 0 */
    private void readWholes(Option option, String separator, String like, String... names) throws UsageException {
        if (!has(option)) {
            return;
        }
        String[] parts = text(option).split(separator, -1);
        if (parts.length != names.length) {
            throw new UsageException("expected " + option.flag() + " to be " + like + ", found '" + text(option) + "'");
        }
        int[] all = new int[parts.length];
        for (int i = 0; i < parts.length; i++) {
            int min = names[i].equals("column") || names[i].equals("row") ? 0 : 1;
            all[i] = whole("the " + names[i] + " of " + option.flag(), parts[i], min, Integer.MAX_VALUE);
        }
        numbers.put(option, all);
    }

    private static int whole(String name, String text, int min, int max) throws UsageException {
        long value = text.matches("\\+?\\d{1,10}") ? Long.parseLong(text) : -1;
        if (value < min || value > max) {
            throw new UsageException("expected " + name + " to be a whole number from " + min + " to " + max
                    + ", found '" + text + "'");
        }
        return (int) value;
    }

    private static Sampling sampling(String text) throws UsageException {
        if (text.equals("auto")) {
            return new Sampling.Within(Sampling.Within.INVISIBLE);
        }
        if (!text.startsWith("auto:")) {
            return new Sampling.Grid(whole("--samples, if not 'auto',", text, 1, Sampling.MAX));
        }
        Matcher m = ERROR.matcher(text);
        double error = !m.matches() ? 0
                : Double.parseDouble(m.group(1)) / (m.group(2) == null ? 1 : Double.parseDouble(m.group(2)));
        if (!(error >= Sampling.Within.MIN && error < 1)) {
            throw new UsageException("expected the error of --samples auto:E to be like 0.002 or 1/255, from 0.0001"
                    + " to below 1, found '" + text.substring("auto:".length()) + "'");
        }
        return new Sampling.Within(error);
    }

    public List<String> scenes() {
        return scenes;
    }

    public boolean has(Option option) {
        return values.containsKey(option);
    }

    /** The value as it was given; null if it was not. */
    public String text(Option option) {
        return values.get(option);
    }

    /** Whether pictures are compared as a class's hand-ins are: each has a line, and none is written unless that is asked for. */
    public boolean isGrading() {
        return has(Option.COMPARE) && (scenes.size() > 1 || new File(text(Option.COMPARE)).isDirectory());
    }

    /** Whether pictures go into a folder, by the names of their scenes. */
    public boolean isOutputFolder() {
        return scenes.size() > 1 || text(Option.OUTPUT).endsWith("/");
    }

    public int threads() {
        return whole(Option.THREADS, Runtime.getRuntime().availableProcessors());
    }

    public int chartSeconds() {
        return whole(Option.CHART_SECONDS, DEFAULT_SECONDS);
    }

    /** The value of an option that is a whole number, or what it is if the option is not given. */
    public int whole(Option option, int otherwise) {
        return has(option) ? numbers.get(option)[0] : otherwise;
    }

    public Sampling sampling() {
        return sampling;
    }

    /** The scene with what the options override. */
    public Scene override(Scene scene) {
        int[] size = numbers.get(Option.SIZE);
        Scene sized = size == null ? scene : scene.withSize(size[0], size[1]);
        return (camera == null ? sized : sized.withCamera(camera)).withMaxDepth(whole(Option.MAXDEPTH, scene.maxDepth()));
    }

    /** The part of a picture of this size that is wanted: all, if none is given. */
    public Region region(int width, int height) throws UsageException {
        int[] r = numbers.get(Option.REGION);
        if (r == null) {
            return Region.whole(width, height);
        }
        long right = (long) r[0] + r[2], bottom = (long) r[1] + r[3];
        if (right > width || bottom > height) {
            throw new UsageException("expected --region to be inside the picture of " + width + "x" + height
                    + ", found columns " + r[0] + " to " + (right - 1) + " and rows " + r[1] + " to " + (bottom - 1));
        }
        return new Region(r[0], r[1], r[2], r[3]);
    }

    /** The column and the row of the pixel that is to be explained, in a picture of this size. */
    public int[] pixel(int width, int height) throws UsageException {
        int[] pixel = numbers.get(Option.EXPLAIN);
        if (pixel[0] >= width || pixel[1] >= height) {
            throw new UsageException("expected --explain to be inside the picture of " + width + "x" + height
                    + ", found column " + pixel[0] + " and row " + pixel[1] + "; both count from 0");
        }
        return pixel;
    }
}
