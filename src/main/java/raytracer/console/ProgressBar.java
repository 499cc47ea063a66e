package raytracer.console;

import java.io.Console;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;

/** Shows on a terminal how far rendering is and how long it will take, once it has lasted a moment. */
public final class ProgressBar {

    private static final long FIRST_MILLIS = 500;
    private static final long NEXT_MILLIS = 200;
    private static final int WIDTH = 20;

    private ProgressBar() { }

    /** Does some work, and shows its progress meanwhile if that is wanted and {@code err} is a terminal. */
    public static <T> T during(Supplier<T> work, PrintStream err, boolean quiet, DoubleSupplier progress) {
        if (quiet || err != System.err || !isTerminal()) {
            return work.get();
        }
        Stopwatch elapsed = new Stopwatch();
        ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
        clock.scheduleAtFixedRate(() -> show(err, line(progress.getAsDouble(), elapsed.millis() / 1e3)),
                FIRST_MILLIS, NEXT_MILLIS, TimeUnit.MILLISECONDS);
        try {
            return work.get();
        } finally {
            close(clock);
            if (elapsed.millis() >= FIRST_MILLIS) {
                show(err, " ".repeat(WIDTH + 24) + "\r");
            }
        }
    }

    /** In place of the terminal's current line. */
    private static void show(PrintStream err, String line) {
        err.print("\r" + line);
        err.flush();
    }

    private static void close(ExecutorService clock) {
        clock.shutdown();
        try {
            clock.awaitTermination(NEXT_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static boolean isTerminal() {
        Path standardError = Path.of("/proc/self/fd/2");
        try {
            if (Files.isSymbolicLink(standardError)) {
                return Files.readSymbolicLink(standardError).toString().matches("/dev/(pts/|tty).*");
            }
        } catch (IOException e) {
            return false;
        }
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            // Since Java 22 there is a console without a terminal; this asks it.
            return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException e) {
            return true;
        }
    }

    public static String line(double part, double seconds) {
        int full = (int) (WIDTH * part);
        double secondsLeft = Math.ceil(seconds * (1 - part) / part);
        String left = part > 0 ? String.format(Locale.ROOT, ", %.0f s left", secondsLeft) : "";
        return String.format(Locale.ROOT, "[%s%s] %3.0f %%%s  ", "#".repeat(full), " ".repeat(WIDTH - full),
                Math.floor(100 * part), left);
    }
}
