package raytracer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.image.BufferedImage;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

@DisplayName("A picture's bytes")
class ImageTest {

    private static int exact(double c) {
        BigDecimal steps = new BigDecimal(Math.min(1, Math.max(0, c))).multiply(BigDecimal.valueOf(255));
        return steps.add(new BigDecimal("0.5")).setScale(0, RoundingMode.FLOOR).intValueExact();
    }

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
    void areRoundedExactlyWhereTheProductIsNot() {
        // .3 is a little less than 76.5 / 255, but 255 * .3 rounds to 76.5.
        assertEquals(76.5, 255 * .3);
        assertEquals(76, byteOf(.3));
        Random random = new Random(1);
        for (int step = 0; step < 255; step++) {
            double tie = (step + .5) / 255;
            for (double c = tie - 4 * Math.ulp(tie); c <= tie + 4 * Math.ulp(tie); c = Math.nextUp(c)) {
                assertEquals(exact(c), byteOf(c), () -> "near step " + tie);
            }
            double any = random.nextDouble();
            assertEquals(exact(any), byteOf(any));
        }
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
