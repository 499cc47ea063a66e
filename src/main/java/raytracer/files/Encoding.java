package raytracer.files;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import raytracer.image.Image;
import raytracer.image.PngFile;

/** Writes a picture while it is being rendered, in a thread of its own that waits for each row. */
public final class Encoding {

    private final FutureTask<Void> writing;

    /** Begins at once; if it fails, so does whoever sets the picture's pixels. */
    public Encoding(Image image, Destination destination) {
        writing = new FutureTask<>(() -> {
            try {
                destination.write(image.rowByRow());
            } catch (IOException | RuntimeException | Error e) {
                image.fail(new IllegalStateException("the picture cannot be written", e));
                throw e;
            }
            return null;
        });
        start(writing);
    }

    /** Lets the library's encoder load, which takes a third of a second when a program has just started. */
    public static void prepare() {
        start(PngFile::prepare);
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "encoder");
        thread.setDaemon(true);
        // Whatever goes wrong while the encoder loads goes wrong again when it is used, and is told then.
        thread.setUncaughtExceptionHandler((failed, reason) -> { });
        thread.start();
    }

    /** Throws why the picture could not be written, if that is why its pixels cannot be set any more. */
    public void throwCause() throws IOException {
        try {
            await();
        } catch (IllegalStateException consequence) {
            // Whoever sets the pixels failed first, and the encoder therefore.
        }
    }

    /** Returns when the picture is written. */
    public void await() throws IOException {
        try {
            writing.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException failure) {
                throw failure;
            }
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
