package raytracer.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import raytracer.image.Image;
import raytracer.parser.SceneException;
import raytracer.parser.Scenes;
import raytracer.scene.Camera;
import raytracer.scene.Vector;
import raytracer.tracer.Pictures;

/** The rest of the arithmetic holds. */
class ArithmeticStabilityTest {

    @Test
    @DisplayName("up parallel to the view is refused; a cross product alone makes noise of it that rolls the camera")
    void up() throws Exception {
        Random random = new Random(1);
        int noise = 0, tried = 0;
        for (int i = 0; i < 1000; i++) {
            // Whole numbers, exactly parallel: but their unit vectors are not.
            Vector view = new Vector(1 + random.nextInt(50), 1 + random.nextInt(50), 1 + random.nextInt(50));
            int k = 2 + random.nextInt(9);
            Vector up = new Vector(k * view.x(), k * view.y(), k * view.z());
            Vector cross = up.unit().cross(view.unit());
            noise += cross.length() > 0 ? 1 : 0;
            tried++;
            assertFalse(new Camera(view, new Vector(0, 0, 0), up, 45).upIsClear());
        }
        assertTrue(noise > tried / 10, noise + " of " + tried + " made of noise");
        assertThrows(SceneException.class, () -> Scenes.parse("size 2 2\ncamera 3 3 3 0 0 0 7 7 7 45\n"));
        assertTrue(new Camera(new Vector(0, 0, 1), new Vector(0, 0, 0), new Vector(1e-9, 0, 1), 45).upIsClear());
    }

    @Test
    @DisplayName("no highlight is ever NaN, whatever its exponent")
    void highlights() throws Exception {
        assertTrue(Double.isNaN(0 * Math.pow(0, -1)), "0 times an infinite highlight");
        assertTrue(Math.pow(1 + Math.ulp(1.0), 1e18) > 1e90, "a cosine a bit above 1");
        for (String exponent : new String[] {"0", "-1", "1", "1e18", "-1e18", "1e-18", "1e308", "-1e308", "4.9e-324"}) {
            for (String specular : new String[] {"0 0 0", "1 0 .5", "1e308 0 1e-308"}) {
                double[] colours = Pictures.trace("size 8 8\ncamera 0 0 5 0 0 0 0 1 0 45\nmaxdepth 3\nambient .1 .1 .1\n"
                        + "shininess " + exponent + "\nspecular " + specular + "\nsphere 0 0 0 1\nplane 0 0 -2 0 0 1\n"
                        + "directional 0 0 -1 1 0 1\ndirectional 0 0 1 1 1 1\npoint 0 0 5 1 1 0\n");
                for (double c : colours) {
                    assertTrue(c >= 0, exponent + ", " + specular + ": " + c);
                }
            }
        }
    }

    @Test
    @DisplayName("no highlight is more than full, though its cosine may round to more than 1")
    void fullHighlights() throws Exception {
        Random random = new Random(2);
        int above = 0;
        for (int i = 0; i < 500; i++) {
            Vector n = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            above += n.dot(n) > 1 ? 1 : 0;
            String eye = 5 * n.x() + " " + 5 * n.y() + " " + 5 * n.z();
            double[] c = Pictures.trace("size 1 1\ncamera " + eye + " 0 0 0 .3 .5 .7 45\nshininess 1e18\nspecular 1 1 1\n"
                    + "plane 0 0 0 " + n.x() + " " + n.y() + " " + n.z() + "\npoint " + eye + " 1 1 1\n");
            assertTrue(c[0] <= 1, "a highlight of " + c[0]);
        }
        assertTrue(above > 50, above + " unit vectors longer than 1");
    }

    @Test
    @DisplayName("a byte is what its decimal means: 1 is 255 and does not wrap, .7 is 179")
    void bytes() {
        assertEquals(0, (byte) (int) (256.0 * 1) & 255, "256 steps wrap");
        assertEquals(178, new BigDecimal(.7).multiply(BigDecimal.valueOf(255)).add(new BigDecimal(".5")).intValue(),
                "the double .7 is less than half a step");
        Image image = new Image(1, 1);
        image.setPixels(0, 0, 1, 1, new double[] {1}, new double[] {.7}, new double[] {1e300});
        assertEquals(0xFFB3FF, image.rgb(0, 0));
    }

    @Test
    @DisplayName("a scene far from the origin is the same scene: the origin is taken off before anything is multiplied")
    void farAway() throws Exception {
        // Coordinates that stay exact when 2^30 is added to them.
        double[] near = Pictures.trace(cubes(0)), far = Pictures.trace(cubes(0x1p30));
        double worst = 0;
        for (int i = 0; i < near.length; i++) {
            worst = Math.max(worst, Math.abs(near[i] - far[i]));
        }
        assertTrue(worst < 1e-6, "a colour is off by " + worst);
        assertEquals(0x1p30f, 0x1p30f + 1f, "floats do not even hold the coordinates");
    }

    private static String cubes(double offset) {
        Families.Writer w = new Families.Writer(new Random(1), 1, offset);
        w.text("size 24 18\nmaxverts 100\ndirectional 1 2 3 .8 .8 .8\nambient .1 .1 .1\ndiffuse .7 .5 .3");
        w.move("camera", new double[] {3, 2, 5});
        w.add(new double[] {0, 0, 0}).end(" 0 1 0 40");
        w.box(0, -1, 0, 1, 1);
        w.box(.25, 0, .25, .5, .5);
        w.line("sphere", -.5, .5, .5, .5);
        return w.toString();
    }
}
