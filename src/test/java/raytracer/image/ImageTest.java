package raytracer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** A picture's bytes. */
class ImageTest {

    /** What a colour's component becomes. */
    static int byteOf(double c) {
        Image image = new Image(1, 1);
        image.setPixels(0, 0, 1, 1, new double[] {c}, new double[1], new double[1]);
        return image.rgb(0, 0) >> 16;
    }

    @Test
    void areColoursCutAndRounded() {
        assertEquals(0, byteOf(-1));
        assertEquals(0, byteOf(0));
        assertEquals(128, byteOf(.5));
        assertEquals(255, byteOf(1));
        assertEquals(255, byteOf(Double.POSITIVE_INFINITY));
        assertEquals(0, byteOf(Double.NaN));
    }

    @Test
    @DisplayName("are those that the standard library's colours of floats have")
    void areTheStandardLibrarys() {
        Random random = new Random(1);
        for (int step = 0; step < 255; step++) {
            double between = (step + .5) / 255;
            for (double c = between - 1e-7; c <= between + 1e-7; c += 1e-9) {
                assertEquals(standard(c), byteOf(c), "near " + between);
            }
            double any = random.nextDouble();
            assertEquals(standard(any), byteOf(any));
        }
    }

    private static int standard(double c) {
        return new Color((float) c, 0, 0).getRed();
    }

    @Test
    @DisplayName("are what the author of a decimal means: .3 of 255 is 76.5, which rounds up")
    void areWhatDecimalsMean() {
        int[] tenths = {0, 26, 51, 77, 102, 128, 153, 179, 204, 230, 255};
        for (int i = 0; i <= 10; i++) {
            assertEquals(tenths[i], byteOf(i / 10.0), i + " tenths");
        }
        assertTrue(new BigDecimal(.3).multiply(BigDecimal.valueOf(255)).compareTo(new BigDecimal("76.5")) < 0,
                "the double .3 is less than that");
    }

    @Test
    void standWhereTheyWereSet() {
        Image image = new Image(4, 3);
        image.setPixels(1, 1, 2, 2, new double[] {.2, 1, 0, .4}, new double[] {.4, .5, .2, 0},
                new double[] {.6, 0, 1, .8});
        int[][] wanted = {{0, 0, 0, 0}, {0, 0x336699, 0xFF8000, 0}, {0, 0x0033FF, 0x6600CC, 0}};
        BufferedImage standard = image.toBufferedImage();
        for (int y = 0; y < 3; y++) {
            for (int x = 0; x < 4; x++) {
                assertEquals(wanted[y][x], image.rgb(x, y), x + " " + y);
                assertEquals(0xFF000000 | wanted[y][x], standard.getRGB(x, y), x + " " + y);
            }
        }
    }

    @Test
    void thatAreNoNumberAreCounted() {
        Image image = new Image(5, 1);
        double nan = Double.NaN;
        image.setPixels(0, 0, 1, 1, new double[1], new double[1], new double[1]);
        assertEquals(0, image.undefinedPixels());
        image.setPixels(1, 0, 4, 1, new double[] {nan, 0, 0, nan}, new double[] {0, nan, 0, nan},
                new double[] {0, 0, nan, 0});
        assertEquals(4, image.undefinedPixels());
        for (int component = 0; component < 3; component++) {
            double[][] colours = new double[3][6];
            colours[component][1] = nan;
            Image two = new Image(3, 2);
            two.setPixels(0, 0, 3, 2, colours[0], colours[1], colours[2]);
            assertEquals(1, two.undefinedPixels(), "component " + component);
        }
    }

    @Test
    void haveALimit() {
        assertThrows(IllegalArgumentException.class, () -> new Image(30_000, 30_000));
        assertEquals(2_700_000_000L, Image.bytes(30_000, 30_000));
    }
}
