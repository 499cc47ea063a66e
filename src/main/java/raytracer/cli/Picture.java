package raytracer.cli;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;
import raytracer.image.Image;
import raytracer.image.PngFile;
import raytracer.image.RowStream;
import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/** A picture on its way from the renderer to its file: as a whole, or encoded while it is being rendered. */
sealed interface Picture {

    PixelSink sink();

    /**
     * Renders it.
     *
     * @throws IOException if meanwhile it turns out that it cannot be written
     */
    RayCounts during(Supplier<RayCounts> rendering) throws IOException;

    /** Returns when it is written. */
    void write(Destination destination) throws IOException;

    long undefinedPixels();

    boolean isBlack();

    /** Lets the encoder load while the picture is rendered: a third of a second when a program has just started. */
    static void loadEncoder() {
        Thread thread = new Thread(PngFile::prepare, "encoder");
        thread.setDaemon(true);
        // Whatever goes wrong there goes wrong again when the picture is written, and is told then.
        thread.setUncaughtExceptionHandler((failed, reason) -> { });
        thread.start();
    }

    /** One that stays in memory: to be rendered several times, or looked at before it is written. */
    record Whole(Image image) implements Picture {

        static Whole of(int width, int height) throws IOException {
            try {
                return new Whole(new Image(width, height));
            } catch (IllegalArgumentException | OutOfMemoryError e) {
                long megabytes = Image.bytes(width, height) >> 20;
                throw new IOException("a picture of " + width + "x" + height + " pixels is too large for --repeat and"
                        + " --compare: they need " + megabytes + " MB for it, and Java may use "
                        + (Runtime.getRuntime().maxMemory() >> 20) + " MB; 'java -Xmx...m -jar ...' allows more", e);
            }
        }

        @Override
        public PixelSink sink() {
            return image;
        }

        @Override
        public RayCounts during(Supplier<RayCounts> rendering) {
            return rendering.get();
        }

        @Override
        public void write(Destination destination) throws IOException {
            destination.write(image.toBufferedImage());
        }

        @Override
        public long undefinedPixels() {
            return image.undefinedPixels();
        }

        @Override
        public boolean isBlack() {
            return image.isBlack();
        }
    }

    /** One that is never in memory as a whole. */
    final class Streamed implements Picture {

        private final RowStream rows;
        private final FutureTask<Void> writing;

        Streamed(int width, int height, Destination destination) throws IOException {
            try {
                rows = new RowStream(width, height, Tracer.TILE_SIDE);
            } catch (ArithmeticException e) {
                throw new IOException("a picture of " + width + "x" + height + " pixels is too large", e);
            }
            writing = new FutureTask<>(() -> {
                try {
                    destination.write(rows);
                } catch (IOException | RuntimeException | Error e) {
                    rows.fail(new IllegalStateException("the picture cannot be written", e));
                    throw e;
                }
                return null;
            });
            Thread thread = new Thread(writing, "encoder");
            thread.setDaemon(true);
            thread.start();
        }

        @Override
        public PixelSink sink() {
            return rows;
        }

        @Override
        public RayCounts during(Supplier<RayCounts> rendering) throws IOException {
            try {
                return rendering.get();
            } catch (RuntimeException | Error e) {
                if (e.getCause() instanceof IOException cannotWrite) {
                    throw cannotWrite;
                }
                if (e.getCause() instanceof OutOfMemoryError noMemory) {
                    throw noMemory;
                }
                rows.fail(new IllegalStateException("the picture cannot be rendered", e));
                throw e;
            }
        }

        @Override
        public void write(Destination destination) throws IOException {
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

        @Override
        public long undefinedPixels() {
            return rows.undefinedPixels();
        }

        @Override
        public boolean isBlack() {
            return rows.isBlack();
        }
    }
}
