package raytracer.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Does a job again whenever its scene is saved, until the thread is interrupted. What a folder says of the file is asked
 * again and again, so an editor may write it in place or replace it.
 */
final class Watching {

    /** How often to ask. A file that has not changed for so long is whole. */
    private static final long MILLIS = 20;

    private final List<Input> inputs;
    private final Consumer<Input> job;
    private final Map<Input, Stamp> seen = new HashMap<>();
    private final Map<Input, Stamp> done = new HashMap<>();

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

    Watching(List<Input> inputs, Consumer<Input> job) {
        this.inputs = inputs;
        this.job = job;
    }

    /** Returns when the thread is interrupted. */
    void run() {
        try {
            while (true) {
                for (Input input : inputs) {
                    doIfSaved(input);
                }
                Thread.sleep(MILLIS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** What is saved meanwhile is seen the next time, however often it was. */
    private void doIfSaved(Input input) {
        Stamp now = Stamp.of(input), before = seen.put(input, now);
        boolean isWhole = now != null && (now.equals(before) || done.isEmpty());
        if (isWhole && !now.equals(done.get(input))) {
            done.put(input, now);
            job.accept(input);
        }
    }
}
