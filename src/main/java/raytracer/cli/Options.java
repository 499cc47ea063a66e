package raytracer.cli;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What the command line asks for.
 *
 * @param output   null if the scene decides
 * @param width    0 if the scene decides; so is {@code height}
 * @param maxDepth 0 if the scene decides
 * @param stats    null if none are wanted
 */
record Options(List<String> scenes, String output, int width, int height, int maxDepth, int threads, boolean quiet,
        int repeat, String stats, boolean check, boolean help, boolean version) {

    private static final int MOST_THREADS = 1024;

    private static final Pattern SIZE = Pattern.compile("(\\d{1,10})[xX](\\d{1,10})");

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
        private int threads = Runtime.getRuntime().availableProcessors();
        private boolean quiet;
        private int repeat = 1;
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
            }
            return new Options(List.copyOf(scenes), output, width, height, maxDepth, threads, quiet, repeat, stats,
                    check, help, version);
        }

        private void requireScenes() throws UsageException {
            if (scenes.isEmpty()) {
                throw new UsageException("expected a scene file, found none; see --help");
            }
            if (scenes.size() > 1 && (output != null || stats != null)) {
                throw new UsageException((output != null ? "--output" : "--stats")
                        + " goes with one scene, found " + scenes.size());
            }
        }

        private void option(String name, String attached) throws UsageException {
            switch (name) {
                case "-o", "--output" -> output = value(name, attached);
                case "--size" -> size(value(name, attached));
                case "--maxdepth" -> maxDepth = whole(name, value(name, attached), Integer.MAX_VALUE);
                case "--threads" -> threads = whole(name, value(name, attached), MOST_THREADS);
                case "--repeat" -> repeat = whole(name, value(name, attached), Integer.MAX_VALUE);
                case "--stats" -> stats = value(name, attached);
                case "--quiet" -> quiet = flag(name, attached);
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
            Matcher m = SIZE.matcher(text);
            if (!m.matches()) {
                throw new UsageException("expected --size to be like 640x480, found '" + text + "'");
            }
            width = whole("the width of --size", m.group(1), Integer.MAX_VALUE);
            height = whole("the height of --size", m.group(2), Integer.MAX_VALUE);
        }

        private static int whole(String name, String text, int most) throws UsageException {
            long value = text.matches("\\+?\\d{1,10}") ? Long.parseLong(text) : 0;
            if (value < 1 || value > most) {
                throw new UsageException(
                        "expected " + name + " to be a whole number from 1 to " + most + ", found '" + text + "'");
            }
            return (int) value;
        }
    }
}
