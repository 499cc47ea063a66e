package raytracer.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import raytracer.files.OutputFile;

/**
 * Does a job again whenever its scene is saved, until the thread is interrupted. Whether a file was saved is told by
 * what its folder says of it, so an editor may write it in place or replace it; when to look is told by the library's
 * watch service, or by the clock where that does not work.
 */
final class Watching {

    /** How long to wait for a sign of the watch service before looking all the same. */
    private static final long LOOK_MILLIS = 200;

    /** A file that has not changed for so long is whole. */
    private static final long SETTLE_MILLIS = 20;

    private final List<Input> inputs;
    private final Consumer<Input> job;
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
        try (WatchService service = watchFolders()) {
            while (true) {
                for (Input input : inputs) {
                    doIfSaved(input);
                }
                await(service);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            // The service could not be closed, when nobody needs it any more.
        }
    }

    /** Null where there is no service, as for some kinds of folders. */
    private WatchService watchFolders() {
        try {
            WatchService service = Path.of("").getFileSystem().newWatchService();
            for (Input input : inputs) {
                OutputFile.folder(OutputFile.place(input.path())).register(service,
                        StandardWatchEventKinds.ENTRY_CREATE, StandardWatchEventKinds.ENTRY_MODIFY);
            }
            return service;
        } catch (IOException | UnsupportedOperationException e) {
            return null;
        }
    }

    private static void await(WatchService service) throws InterruptedException {
        if (service == null) {
            Thread.sleep(LOOK_MILLIS);
            return;
        }
        WatchKey key = service.poll(LOOK_MILLIS, TimeUnit.MILLISECONDS);
        if (key != null) {
            key.pollEvents();
            key.reset();
        }
    }

    /** What is saved meanwhile is seen the next time, however often it was. */
    private void doIfSaved(Input input) throws InterruptedException {
        Stamp now = Stamp.of(input);
        if (now == null || now.equals(done.get(input))) {
            return;
        }
        Stamp before;
        do {
            before = now;
            Thread.sleep(done.isEmpty() ? 0 : SETTLE_MILLIS);
            now = Stamp.of(input);
        } while (!before.equals(now) && now != null);
        if (now != null) {
            done.put(input, now);
            job.accept(input);
        }
    }
}
