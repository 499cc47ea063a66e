package raytracer.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Arithmetic of 104 bits. */
class ExactTest {

    private static final MathContext DIGITS = new MathContext(60);

    private static BigDecimal big(Exact x) {
        return new BigDecimal(x.high()).add(new BigDecimal(x.low()));
    }

    private static void assertClose(BigDecimal expected, Exact actual) {
        BigDecimal error = big(actual).subtract(expected).abs();
        assertTrue(error.compareTo(expected.abs().multiply(new BigDecimal(0x1p-98))) <= 0, expected + " " + actual);
    }

    @Test
    void roundsByHardlyAnything() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            Exact a = new Exact(random.nextGaussian(), 0).over(new Exact(random.nextGaussian() + 10, 0));
            Exact b = new Exact(Math.scalb(random.nextGaussian(), random.nextInt(60) - 30), 0).times(Exact.of(1 / 3.0));
            assertClose(big(a).multiply(big(b)), a.times(b));
            assertClose(big(a).divide(big(b), DIGITS), a.over(b));
            assertClose(big(a.abs()).sqrt(DIGITS), a.abs().root());
            BigDecimal sum = big(a).add(big(b));
            BigDecimal error = big(a.plus(b)).subtract(sum).abs();
            assertTrue(error.compareTo(big(a).abs().add(big(b).abs()).multiply(new BigDecimal(0x1p-100))) <= 0);
        }
    }

    @Test
    void knowsTangents() {
        assertClose(BigDecimal.ONE, new Exact(Math.PI, 1.2246467991473532e-16).times(.25).tangent());
        // The root of 3, and that of 1/3.
        Exact third = new Exact(Math.PI, 1.2246467991473532e-16).over(Exact.of(3));
        assertClose(BigDecimal.valueOf(3).sqrt(DIGITS), third.tangent());
        assertClose(BigDecimal.ONE.divide(BigDecimal.valueOf(3), DIGITS).sqrt(DIGITS), third.times(.5).tangent());
    }

    @Test
    void knowsPowers() {
        Exact x = Exact.of(9).over(Exact.of(10));
        assertClose(big(x).pow(37), x.power(37));
        assertEquals(Math.pow(.9, 2.5), x.power(2.5).high(), 1e-15);
        assertEquals(Double.POSITIVE_INFINITY, Exact.ZERO.power(-1).high());
        assertEquals(1, Exact.ZERO.power(0).high());
    }
}
