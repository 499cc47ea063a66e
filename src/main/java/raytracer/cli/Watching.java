package raytracer.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import raytracer.console.ExitStatus;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Destination;
import raytracer.files.Places;
import raytracer.files.UsageException;

/**
 * Renders a scene again whenever it is saved, until the thread is interrupted, in this process: the second picture takes a
 * fraction of the first one's time. What a folder says of the file is asked again and again, so an editor may write it in
 * place or replace it.
 */
final class Watching {

    /** How often to ask. */
    private static final long MILLIS = 20;

    /** A file that has not changed for so long is whole: an editor or a network may take as long to write it. */
    private static final long STILL_MILLIS = 200;

    private final Options options;
    private final Terminal terminal;
    private final List<Watched> all = new ArrayList<>();

    Watching(Options options, Terminal terminal) {
        this.options = options;
        this.terminal = terminal;
    }

    /** Returns the exit status when the thread is interrupted, or at once if this can never succeed. */
    int run() throws UsageException, IOException {
        Places places = new Places();
        for (String scene : options.scenes()) {
            Watched watched = new Watched(new Input(scene));
            if (watched.input.isStandard() || Files.isDirectory(watched.input.path())) {
                throw new UsageException("--watch goes with files, found "
                        + (watched.input.isStandard() ? "standard input" : "the directory " + scene));
            }
            all.add(watched);
            watched.prepare(places);
        }
        try {
            while (true) {
                for (Watched watched : all) {
                    watched.lookAgain();
                }
                Thread.sleep(MILLIS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return ExitStatus.DONE;
        }
    }

    /** What tells one version of a file from another. */
    private record Stamp(FileTime time, long size, Object key) {

        /** Null while there is no file. */
        static Stamp of(Input input) {
            try {
                BasicFileAttributes file = Files.readAttributes(input.path(), BasicFileAttributes.class);
                return new Stamp(file.lastModifiedTime(), file.size(), file.fileKey());
            } catch (IOException e) {
                return null;
            }
        }
    }

    private static long millis() {
        return System.nanoTime() / 1_000_000;
    }

    private final class Watched {
        private final Input input;
        private Job job;
        private Stamp seen;
        private Stamp done;
        private long changedMillis = millis() - STILL_MILLIS;
        private boolean isMissed;

        /** Where its picture went: if a version, half written maybe, names no output, that does not change. */
        private Destination destination;

        Watched(Input input) {
            this.input = input;
            seen = Stamp.of(input);
        }

        void prepare(Places places) throws UsageException {
            job = new Job(input, options, terminal);
            job.prepare(places, destination);
            destination = job.destination() == null ? destination : job.destination();
        }

        /** What is saved meanwhile is seen the next time, however often it was. */
        void lookAgain() {
            Stamp now = Stamp.of(input);
            if (now == null && !isMissed) {
                terminal.tell(input.name() + ": there is no such file; it is rendered when there is one");
            }
            isMissed = now == null;
            changedMillis = now == null || now.equals(seen) ? changedMillis : millis();
            seen = now;
            if (now != null && !now.equals(done) && millis() - changedMillis >= STILL_MILLIS) {
                done = now;
                render();
            }
        }

        private void render() {
            Places places = new Places();
            try {
                for (Watched other : all) {
                    if (other != this && other.destination != null) {
                        places.write(other.destination.file(), "the picture of " + other.input.name());
                    }
                }
                prepare(places);
                job.run();
            } catch (UsageException | IOException e) {
                terminal.tell(input.name() + ": " + e.getMessage());
            }
        }
    }
}
