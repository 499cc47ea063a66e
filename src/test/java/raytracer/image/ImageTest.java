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

    @Test
    void areColoursCutAndRounded() {
        assertEquals(0, Image.quantise(-1) & 255);
        assertEquals(0, Image.quantise(0) & 255);
        assertEquals(128, Image.quantise(.5) & 255);
        assertEquals(255, Image.quantise(1) & 255);
        assertEquals(255, Image.quantise(Double.POSITIVE_INFINITY) & 255);
        assertEquals(0, Image.quantise(Double.NaN) & 255);
    }

    @Test
    void areRoundedExactlyWhereTheProductIsNot() {
        // .3 is a little less than 76.5 / 255, but 255 * .3 rounds to 76.5.
        assertEquals(76.5, 255 * .3);
        assertEquals(76, Image.quantise(.3) & 255);
        Random random = new Random(1);
        for (int step = 0; step < 255; step++) {
            double tie = (step + .5) / 255;
            for (double c = tie - 4 * Math.ulp(tie); c <= tie + 4 * Math.ulp(tie); c = Math.nextUp(c)) {
                assertEquals(exact(c), Image.quantise(c) & 255, () -> "near step " + tie);
            }
            double any = random.nextDouble();
            assertEquals(exact(any), Image.quantise(any) & 255);
        }
    }

    @Test
    void standWhereTheyWereSet() {
        Image image = new Image(3, 2);
        image.setRow(1, 1, 2, new double[] {9, .2, 1}, new double[] {9, .4, .5}, new double[] {9, .6, 0}, 1);
        assertEquals(0xFF8000, image.rgb(2, 1));
        assertEquals(0x336699, image.rgb(1, 1));
        assertEquals(0, image.rgb(0, 1));
        BufferedImage standard = image.toBufferedImage();
        assertEquals(0xFFFF8000, standard.getRGB(2, 1));
        assertEquals(0xFF000000, standard.getRGB(0, 0));
    }

    @Test
    void thatAreNoNumberAreCounted() {
        Image image = new Image(5, 1);
        double nan = Double.NaN;
        image.setRow(0, 0, 1, new double[1], new double[1], new double[1], 0);
        assertEquals(0, image.undefinedPixels());
        image.setRow(1, 0, 4, new double[] {nan, 0, 0, nan}, new double[] {0, nan, 0, nan},
                new double[] {0, 0, nan, 0}, 0);
        assertEquals(4, image.undefinedPixels());
    }

    @Test
    void haveALimit() {
        assertThrows(IllegalArgumentException.class, () -> new Image(30_000, 30_000));
        assertEquals(2_700_000_000L, Image.bytes(30_000, 30_000));
    }
}
