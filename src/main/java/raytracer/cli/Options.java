package raytracer.cli;

import java.io.File;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import raytracer.render.Region;
import raytracer.render.Sampling;

/**
 * What the command line asks for.
 *
 * @param output    null if the scene decides; {@link #STANDARD} for standard output
 * @param width     0 if the scene decides; so is {@code height}
 * @param maxDepth  0 if the scene decides
 * @param region    null for the whole picture
 * @param reference null if there is nothing to compare with
 * @param difference null for the usual place
 * @param tolerance by how much components may differ from the reference, of 255
 * @param chart     null if none is wanted
 * @param stats     null if none are wanted
 */
record Options(List<String> scenes, String output, int width, int height, int maxDepth, Sampling sampling,
        Region region, int threads, boolean quiet, boolean verbose, int repeat, String reference, String difference, int tolerance,
        String chart, int chartSeconds, String stats, boolean check, boolean help, boolean version) {

    /** In place of a file's name: standard input or output. */
    static final String STANDARD = "-";

    private static final int MOST_THREADS = 1024;
    private static final int MOST_SECONDS = 24 * 60 * 60;

    private static final String SIZE = "(\\d{1,10})[xX](\\d{1,10})";
    private static final String REGION = "(\\d{1,10}),(\\d{1,10}),(\\d{1,10}),(\\d{1,10})";

    /** A number or a fraction. */
    private static final String ERROR = "auto:(\\d*\\.?\\d+)(?:/(\\d*\\.?\\d+))?";

    static Options parse(String[] args) throws UsageException {
        return new Reader(List.of(args).iterator()).read();
    }

    /** The options while they are being read. */
    private static final class Reader {
        private final Iterator<String> args;
        private final List<String> scenes = new ArrayList<>();
        private String output;
        private int width;
        private int height;
        private int maxDepth;
        private Sampling sampling = Sampling.CENTRES;
        private Region region;
        private int threads = Runtime.getRuntime().availableProcessors();
        private boolean quiet;
        private boolean verbose;
        private int repeat = 1;
        private String reference;
        private String difference;
        private int tolerance = -1;
        private String chart;
        private int chartSeconds;
        private String stats;
        private boolean check;
        private boolean help;
        private boolean version;

        Reader(Iterator<String> args) {
            this.args = args;
        }

        Options read() throws UsageException {
            while (args.hasNext()) {
                String arg = args.next();
                if (arg.equals("--")) {
                    args.forEachRemaining(scenes::add);
                } else if (arg.startsWith("-") && arg.length() > 1) {
                    int equals = arg.startsWith("--") ? arg.indexOf('=') : -1;
                    option(equals < 0 ? arg : arg.substring(0, equals), equals < 0 ? null : arg.substring(equals + 1));
                } else {
                    scenes.add(arg);
                }
            }
            if (!help && !version) {
                requireScenes();
                requireSense();
            }
            return new Options(List.copyOf(scenes), output, width, height, maxDepth, sampling, region, threads, quiet,
                    verbose, repeat, reference, difference, Math.max(tolerance, 0), chart, chartSeconds == 0 ? 60 : chartSeconds,
                    stats, check, help, version);
        }

        private void requireScenes() throws UsageException {
            if (scenes.isEmpty()) {
                throw new UsageException("expected a scene file, found none; see --help");
            }
            String alone = output != null ? "--output" : stats != null ? "--stats" : difference != null ? "--diff"
                    : chart != null ? "--chart" : isFile(reference) ? "--compare with a file (not a folder)" : null;
            if (scenes.size() > 1 && alone != null) {
                throw new UsageException(alone + " goes with one scene, found " + scenes.size());
            }
        }

        private static boolean isFile(String reference) {
            return reference != null && !new File(reference).isDirectory();
        }

        private void requireSense() throws UsageException {
            if (tolerance >= 0 && reference == null) {
                throw new UsageException("--tolerance goes with --compare, found none");
            }
            if (difference != null && reference == null) {
                throw new UsageException("--diff goes with --compare, found none");
            }
            if (chartSeconds > 0 && chart == null) {
                throw new UsageException("--chart-seconds goes with --chart, found none");
            }
            if (chart != null) {
                requireSenseOfChart();
            }
        }

        private void requireSenseOfChart() throws UsageException {
            String single = reference != null ? "--compare" : region != null ? "--region" : output != null ? "--output"
                    : !sampling.equals(Sampling.CENTRES) ? "--samples" : repeat > 1 ? "--repeat"
                    : stats != null ? "--stats" : null;
            if (single != null) {
                throw new UsageException("--chart goes without " + single + ": it tries many settings in turns,"
                        + " and writes a chart in place of a picture");
            }
            if (!chart.endsWith(".svg")) {
                throw new UsageException("expected the file of --chart to end in '.svg', found '" + chart + "'");
            }
        }

        private void option(String name, String attached) throws UsageException {
            switch (name) {
                case "-o", "--output" -> output = value(name, attached);
                case "--size" -> size(value(name, attached));
                case "--maxdepth" -> maxDepth = whole(name, value(name, attached), 1, Integer.MAX_VALUE);
                case "--samples" -> sampling = sampling(value(name, attached));
                case "--region" -> region = region(value(name, attached));
                case "--threads" -> threads = whole(name, value(name, attached), 1, MOST_THREADS);
                case "--repeat" -> repeat = whole(name, value(name, attached), 1, Integer.MAX_VALUE);
                case "--compare" -> reference = value(name, attached);
                case "--diff" -> difference = value(name, attached);
                case "--tolerance" -> tolerance = whole(name, value(name, attached), 0, 255);
                case "--chart" -> chart = value(name, attached);
                case "--chart-seconds" -> chartSeconds = whole(name, value(name, attached), 1, MOST_SECONDS);
                case "--stats" -> stats = value(name, attached);
                case "--quiet" -> quiet = flag(name, attached);
                case "--verbose" -> verbose = flag(name, attached);
                case "--check" -> check = flag(name, attached);
                case "-h", "--help" -> help = flag(name, attached);
                case "--version" -> version = flag(name, attached);
                default -> throw new UsageException("unknown option '" + name + "'; see --help");
            }
        }

        private static boolean flag(String name, String attached) throws UsageException {
            if (attached != null) {
                throw new UsageException(name + " takes no value, found '" + attached + "'");
            }
            return true;
        }

        private String value(String name, String attached) throws UsageException {
            String value = attached != null ? attached : args.hasNext() ? args.next() : "";
            if (value.isEmpty()) {
                throw new UsageException("expected a value after " + name + ", found none");
            }
            return value;
        }

        private void size(String text) throws UsageException {
            Matcher m = Pattern.compile(SIZE).matcher(text);
            if (!m.matches()) {
                throw new UsageException("expected --size to be like 640x480, found '" + text + "'");
            }
            width = whole("the width of --size", m.group(1), 1, Integer.MAX_VALUE);
            height = whole("the height of --size", m.group(2), 1, Integer.MAX_VALUE);
        }

        private static Region region(String text) throws UsageException {
            Matcher m = Pattern.compile(REGION).matcher(text);
            if (!m.matches()) {
                throw new UsageException("expected --region to be like 0,120,640,60: column, row, width and height of a"
                        + " part of the picture, found '" + text + "'");
            }
            return new Region(whole("the column of --region", m.group(1), 0, Integer.MAX_VALUE),
                    whole("the row of --region", m.group(2), 0, Integer.MAX_VALUE),
                    whole("the width of --region", m.group(3), 1, Integer.MAX_VALUE),
                    whole("the height of --region", m.group(4), 1, Integer.MAX_VALUE));
        }

        private static Sampling sampling(String text) throws UsageException {
            if (text.equals("auto")) {
                return new Sampling.Adaptive(Sampling.Adaptive.INVISIBLE);
            }
            if (!text.startsWith("auto:")) {
                return new Sampling.Grid(whole("--samples, if not 'auto',", text, 1, Sampling.MOST));
            }
            Matcher m = Pattern.compile(ERROR).matcher(text);
            double error = !m.matches() ? 0
                    : Double.parseDouble(m.group(1)) / (m.group(2) == null ? 1 : Double.parseDouble(m.group(2)));
            if (!(error >= Sampling.Adaptive.LEAST && error < 1)) {
                throw new UsageException("expected the error of --samples auto:E to be like 0.002 or 1/255, from 0.0001"
                        + " to below 1, found '" + text.substring("auto:".length()) + "'");
            }
            return new Sampling.Adaptive(error);
        }

        private static int whole(String name, String text, int least, int most) throws UsageException {
            long value = text.matches("\\+?\\d{1,10}") ? Long.parseLong(text) : -1;
            if (value < least || value > most) {
                throw new UsageException("expected " + name + " to be a whole number from " + least + " to " + most
                        + ", found '" + text + "'");
            }
            return (int) value;
        }
    }
}
