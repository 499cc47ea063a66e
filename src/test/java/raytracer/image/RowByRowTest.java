package raytracer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@DisplayName("A picture that is encoded while it is rendered")
class RowByRowTest {

    private static final Duration SOON = Duration.ofSeconds(20);

    private static void set(Image image, int left, int y, int count) {
        double[] red = new double[count], green = new double[count], blue = new double[count];
        Arrays.setAll(red, i -> (left + i) / (double) image.width());
        Arrays.fill(green, y / (double) image.height());
        Arrays.fill(blue, .5);
        image.setPixels(left, y, count, 1, red, green, blue);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 37})
    void hasTheBytesOfOneThatIsComplete(int height) {
        assertTimeoutPreemptively(SOON, () -> {
            Image image = new Image(50, height);
            CompletableFuture.runAsync(() -> {
                for (int y = height - 1; y >= 0; y--) {
                    set(image, 16, y, 34);
                    set(image, 0, y, 16);
                }
            });
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            PngFile.write(image.rowByRow(), png);
            BufferedImage read = ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
            for (int y = 0; y < height; y++) {
                for (int x = 0; x < 50; x++) {
                    int wanted = ImageTest.byteOf(x / 50.0) << 16 | ImageTest.byteOf(y / (double) height) << 8 | 128;
                    assertEquals(wanted, read.getRGB(x, y) & 0xFFFFFF);
                }
            }
        });
    }

    @Test
    void waitsForAllOfARow() {
        assertTimeoutPreemptively(SOON, () -> {
            Image image = new Image(10, 2);
            RenderedImage rows = image.rowByRow();
            set(image, 0, 1, 10);
            set(image, 0, 0, 9);
            assertEquals(1, rows.getData(new Rectangle(0, 1, 10, 1)).getMinY(), "the second row is there");
            assertEquals(new Rectangle(0, 1, 10, 1), rows.getTile(0, 1).getBounds(), "each row is a tile");
            assertEquals(1, rows.getTileHeight());
            assertEquals(2, rows.getNumYTiles());
            CompletableFuture<?> first = CompletableFuture.runAsync(() -> rows.getData(new Rectangle(0, 0, 10, 1)));
            CompletableFuture<?> tile = CompletableFuture.runAsync(() -> rows.getTile(0, 0));
            Thread.sleep(100);
            assertFalse(first.isDone() || tile.isDone(), "of the first a pixel is missing");
            set(image, 9, 0, 1);
            first.get();
            tile.get();
        });
    }

    @Test
    void endsTheWaitingOfOneSideWhenTheOtherFails() {
        assertTimeoutPreemptively(SOON, () -> {
            Image image = new Image(10, 10);
            IllegalStateException reason = new IllegalStateException("no more rows");
            CompletableFuture.runAsync(() -> image.fail(reason),
                    CompletableFuture.delayedExecutor(50, TimeUnit.MILLISECONDS));
            assertSame(reason, assertThrows(
                    IllegalStateException.class, () -> image.rowByRow().getData(new Rectangle(0, 0, 10, 1))));
            assertSame(reason, assertThrows(IllegalStateException.class, () -> set(image, 0, 0, 10)));
        });
    }
}
