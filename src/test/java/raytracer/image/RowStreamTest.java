package raytracer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@DisplayName("A picture that is encoded while it is rendered")
class RowStreamTest {

    private static final Duration SOON = Duration.ofSeconds(20);

    private static void set(RowStream rows, int left, int y, int count, int width, int height) {
        double[] red = new double[count], green = new double[count], blue = new double[count];
        Arrays.setAll(red, i -> (left + i) / (double) width);
        Arrays.fill(green, y / (double) height);
        Arrays.fill(blue, .5);
        rows.setPixels(left, y, count, 1, red, green, blue);
    }

    private static void render(RowStream rows, int width, int height, int band, AtomicInteger reached) {
        for (int top = 0; top < height; top += band) {
            rows.awaitRoom(top);
            reached.set(top);
            int end = Math.min(height, top + band);
            for (int y = top; y < end; y++) {
                // In two parts, as tiles send them.
                set(rows, width / 3, y, width - width / 3, width, height);
                set(rows, 0, y, width / 3, width, height);
            }
            rows.tileDone(top, (end - top) * width);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 4, 5, 37})
    void hasTheBytesOfOneInMemory(int height) {
        assertTimeoutPreemptively(SOON, () -> {
            RowStream rows = new RowStream(50, height, 4);
            CompletableFuture.runAsync(() -> render(rows, 50, height, 4, new AtomicInteger()));
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            PngFile.write(rows, png);
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
            for (int y = 0; y < height; y++) {
                for (int x = 0; x < 50; x++) {
                    int wanted = ImageTest.byteOf(x / 50.0) << 16 | ImageTest.byteOf(y / (double) height) << 8 | 128;
                    assertEquals(wanted, image.getRGB(x, y) & 0xFFFFFF);
                }
            }
        });
    }

    @Test
    void letsTheRendererGetAheadByNoMoreThanItsMemoryAllows() {
        assertTimeoutPreemptively(SOON, () -> {
            // 16 rows of 100,000 pixels are 4.8 MB: six bands of them fit into 32 MB.
            RowStream rows = new RowStream(100_000, 16 * 20, 16);
            AtomicInteger reached = new AtomicInteger();
            CompletableFuture<Void> renderer = CompletableFuture.runAsync(() -> render(rows, 100_000, 16 * 20, 16, reached));
            while (reached.get() < 16 * 5) {
                Thread.sleep(5);
            }
            Thread.sleep(300);
            assertEquals(16 * 5, reached.get());
            for (int y = 0; y < 16 * 20; y++) {
                assertEquals(y, rows.getData(new Rectangle(0, y, 100_000, 1)).getMinY());
            }
            renderer.get();
        });
    }

    @Test
    void endsTheWaitingOfOneSideWhenTheOtherFails() {
        assertTimeoutPreemptively(SOON, () -> {
            RowStream rows = new RowStream(10, 10, 2);
            IllegalStateException reason = new IllegalStateException("no more rows");
            CompletableFuture.runAsync(() -> rows.fail(reason), CompletableFuture.delayedExecutor(50,
                    java.util.concurrent.TimeUnit.MILLISECONDS));
            assertSame(reason, assertThrows(IllegalStateException.class, () -> rows.getData(new Rectangle(0, 0, 10, 1))));
            assertSame(reason, assertThrows(IllegalStateException.class, () -> rows.awaitRoom(0)));
        });
    }

    @Test
    void countsPixelsThatAreNoNumber() {
        RowStream rows = new RowStream(2, 1, 1);
        rows.awaitRoom(0);
        rows.setPixels(0, 0, 2, 1, new double[] {Double.NaN, 0}, new double[2], new double[2]);
        assertEquals(1, rows.undefinedPixels());
    }
}
