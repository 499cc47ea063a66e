package raytracer.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.image.Canvas;
import raytracer.image.Image;
import raytracer.parser.Scenes;
import raytracer.scene.Scene;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Tracer;

/** Samples. */
class SamplingTest {

    /** Thin things: a needle about a pixel wide, one of half that, and balls so far away that many share a pixel. */
    private static String thin() {
        StringBuilder s = new StringBuilder("""
                size 160 120
                camera 0 1 6 0 .6 0 0 1 0 45
                maxdepth 3
                point 4 6 5 .9 .9 .9
                diffuse .6 .6 .6
                specular .2 .2 .2
                shininess 40
                plane 0 0 0 0 1 0
                diffuse .8 .2 .1
                maxverts 6
                vertex -1.5 0 0
                vertex -1.46 0 0
                vertex -.9 2.2 0
                vertex 1.2 0 .5
                vertex 1.22 0 .5
                vertex 1.5 2 .5
                tri 0 1 2
                tri 3 4 5
                diffuse .2 .4 .8
                """);
        for (int i = 0; i < 480; i++) {
            s.append("sphere ").append(-8 + i % 40 * .4).append(" .06 ").append(-10 - i / 40 * .8).append(" .06\n");
        }
        return s.toString();
    }

    private static Scene scene(String name) throws Exception {
        String text = name.equals("thin") ? thin() : Files.readString(Path.of("scenes", name + ".scene"));
        return Scenes.parse(text).scene().withSize(160, 120);
    }

    private static Canvas render(Scene scene, Sampling sampling, RayCounts[] counts) {
        Canvas canvas = new Canvas(scene.width(), scene.height());
        counts[0] = new Renderer(Tracer.compile(scene), sampling, 2, Region.whole(scene.width(), scene.height()), canvas)
                .render();
        return canvas;
    }

    private static double value(Canvas canvas, int x, int y, int component) {
        return canvas.values()[3 * (y * canvas.width() + x) + component];
    }

    private static final Map<String, Canvas> CONVERGED = new HashMap<>();

    private static Canvas converged(String name, Scene scene) {
        return CONVERGED.computeIfAbsent(name, n -> render(scene, new Sampling.Lattice(200, 1)));
    }

    private static Canvas render(Scene scene, Sampling sampling) {
        return render(scene, sampling, new RayCounts[1]);
    }

    @Test
    void onAGridAreThePixelsOfALargerPicture() throws Exception {
        Scene scene = scene("first");
        Canvas grid = render(scene, new Sampling.Grid(3));
        Canvas large = render(scene.withSize(480, 360), Sampling.CENTRES);
        for (int y = 0; y < 120; y++) {
            for (int x = 0; x < 160; x++) {
                for (int component = 0; component < 3; component++) {
                    double sum = 0;
                    for (int k = 0; k < 9; k++) {
                        sum += value(large, 3 * x + k % 3, 3 * y + k / 3, component);
                    }
                    assertEquals(sum / 9, value(grid, x, y, component), 1e-6);
                }
            }
        }
    }

    /** Tenths of 255 are half steps: a mean that is off by a unit roundoff must not change the byte. */
    @ParameterizedTest(name = "of one flat colour make its byte, {0} x {0} of them")
    @ValueSource(ints = {1, 2, 3, 5, 7, 10, 13})
    void ofOneColourMakeItsByte(int n) throws Exception {
        Scene scene = Scenes.parse("size 8 2\ncamera 0 0 4 0 0 0 0 1 0 45\nambient .1 .7 .9\nplane 0 0 0 0 0 1\n").scene();
        Image image = new Image(8, 2);
        new Renderer(Tracer.compile(scene), new Sampling.Grid(n), 1, Region.whole(8, 2), image).render();
        for (int i = 0; i < 16; i++) {
            assertEquals(26 << 16 | 179 << 8 | 230, image.rgb(i % 8, i / 8));
        }
    }

    @Test
    void areCutBeforeTheyAreAveraged() throws Exception {
        // A ball that shines at 5 times white, on black: its rim takes the share of the pixel that it covers.
        Scene scene = Scenes.parse("size 32 32\ncamera 0 0 5 0 0 0 0 1 0 45\nambient 5 5 5\nsphere 0 0 0 1\n").scene();
        Canvas canvas = render(scene, new Sampling.Grid(8));
        int between = 0;
        for (int i = 0; i < 32 * 32; i++) {
            double v = value(canvas, i % 32, i / 32, 0);
            assertTrue(v <= 1);
            between += v > .1 && v < .9 ? 1 : 0;
        }
        assertTrue(between > 20, between + " on the rim");
    }

    /** The errors are less than the aim by as much as the aim lies between what whole numbers of samples reach. */
    @ParameterizedTest(name = "auto on {0} keeps to an error of {1}")
    @CsvSource({"thin, .0078", "thin, .0039", "thin, .002", "final, .0078", "final, .0039",
        "sunflower, .0039", "island, .0039", "kaleidoscope, .0039"})
    void keepToTheErrorThatIsAimedAt(String name, double aim) throws Exception {
        Scene scene = scene(name);
        double error = render(scene, new Sampling.Within(aim)).rmse(converged(name, scene));
        assertTrue(error <= 1.2 * aim, error + " instead of " + aim);
    }

    @ParameterizedTest(name = "auto on {0} are at most twice those of the coarsest grid that does, and pilots")
    @ValueSource(strings = {"final", "island", "star", "sunflower", "kaleidoscope"})
    void areNotManyMoreThanOnTheCoarsestGridThatDoes(String name) throws Exception {
        Scene scene = scene(name);
        Canvas reference = converged(name, scene);
        double aim = 1 / 255.0;
        int n = 1;
        while (render(scene, new Sampling.Grid(n)).rmse(reference) > aim) {
            n++;
        }
        RayCounts[] counts = new RayCounts[1];
        render(scene, new Sampling.Within(aim), counts);
        double samples = counts[0].primary() / (160.0 * 120);
        assertTrue(samples <= 2 * n * n + .9, samples + " samples a pixel, and " + n + " x " + n + " do");
    }

    @Test
    void areOneAPixelAndPilotsWhereAllIsEven() throws Exception {
        Scene scene = Scenes.parse("size 640 480\ncamera 0 0 5 0 0 0 0 1 0 45\nambient .2 .4 .6\nplane 0 0 0 0 0 1\n").scene();
        RayCounts[] counts = new RayCounts[1];
        render(scene, new Sampling.Within(.0039), counts);
        assertTrue(counts[0].primary() <= 1.9 * 640 * 480, counts[0].primary() + " rays");
    }

    @Test
    void ofPilotsAreNoMoreThanOfAllPixelsInASmallPicture() throws Exception {
        Scene scene = Scenes.parse("size 16 16\ncamera 0 0 5 0 0 0 0 1 0 45\nambient .2 .4 .6\nplane 0 0 0 0 0 1\n").scene();
        RayCounts[] counts = new RayCounts[1];
        render(scene, new Sampling.Within(.3), counts);
        assertTrue(counts[0].primary() <= 21 * 16 * 16, counts[0].primary() + " rays");
    }

    @Test
    void areMirroredAndTheirAxesExchangedInSomePixels() throws Exception {
        // Six samples of a pixel: four in two of its quarters and two in the others, or the other way round.
        assertEquals(Set.of(2L, 4L), samplesThatMeet("0 0 .5 .5", "0.5 0.5 1 1"));
        // One of them at its left edge if they are in even columns, none if they are in even rows.
        assertEquals(Set.of(0L, 1L), samplesThatMeet("0 0 .12 1"));
    }

    /** How many of six samples are in these parts of a pixel, given by left, top, right and bottom, for 256 pixels. */
    private static Set<Long> samplesThatMeet(String... parts) throws Exception {
        StringBuilder scene = new StringBuilder("size 16 16\ncamera 0 0 8 0 0 0 0 1 0 90\nambient .9 .9 .9\nmaxverts "
                + 1024 * parts.length + "\n");
        StringBuilder triangles = new StringBuilder();
        int first = 0;
        for (String part : parts) {
            double[] p = Arrays.stream(part.split(" ")).mapToDouble(Double::parseDouble).toArray();
            for (int pixel = 0; pixel < 256; pixel++, first += 4) {
                double x = pixel % 16 - 8, y = 8 - pixel / 16;
                scene.append(String.format(Locale.ROOT,
                        "vertex %1$f %2$f 0\nvertex %1$f %4$f 0\nvertex %3$f %4$f 0\nvertex %3$f %2$f 0\n",
                        x + p[0], y - p[1], x + p[2], y - p[3]));
                triangles.append(String.format("tri %d %d %d\ntri %1$d %3$d %d\n", first, first + 1, first + 2, first + 3));
            }
        }
        Canvas canvas = render(Scenes.parse(scene.append(triangles).toString()).scene(), new Sampling.Lattice(6, 0));
        return IntStream.range(0, 256).mapToObj(pixel -> Math.round(value(canvas, pixel % 16, pixel / 16, 0) / .9 * 6))
                .collect(Collectors.toSet());
    }

    private static String slats(double width) {
        StringBuilder text = new StringBuilder("size 160 120\ncamera 0 0 10 0 0 0 0 1 0 45\nambient 1 1 1\nmaxverts 400\n");
        StringBuilder triangles = new StringBuilder();
        for (int i = 0; i < 100; i++) {
            double x = -4 + i * .0811;
            text.append(String.format(Locale.ROOT, "vertex %s -3 0\nvertex %s -3 0\nvertex %s 3 0\nvertex %s 3 0\n", x,
                    x + width, x + width + .01, x + .01));
            triangles.append(String.format("tri %d %d %d\ntri %d %d %d\n", 4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3));
        }
        return text.append(triangles).toString();
    }

    private static String dust() {
        Random random = new Random(3);
        StringBuilder text = new StringBuilder("size 160 120\ncamera 0 0 10 0 0 0 0 1 0 45\nambient 1 .8 .6\n");
        for (int i = 0; i < 300; i++) {
            text.append(String.format(Locale.ROOT, "sphere %s %s 0 .008\n", 10 * random.nextDouble() - 5, 8 * random.nextDouble() - 4));
        }
        return text.toString();
    }

    private static String grid() {
        StringBuilder text = new StringBuilder("size 160 120\ncamera 0 1 0 0 .8 -10 0 1 0 50\ndirectional .3 1 .2 1 1 1\n"
                + "ambient .1 .1 .1\ndiffuse .5 .5 .5\nplane 0 0 0 0 1 0\ndiffuse .9 .2 .1\n");
        for (int i = 0; i < 400; i++) {
            text.append(String.format(Locale.ROOT, "sphere %s .05 %s .05\n", (i % 20 - 10) * 1.5, -3 - i / 20 * 1.5));
        }
        return text.toString();
    }

    @ParameterizedTest(name = "auto on {0} keeps to an error of one in {1}, though most of what is seen is thinner than a pixel")
    @CsvSource({"slats, 64", "slats, 255", "narrow slats, 64", "narrow slats, 255", "dust, 64", "dust, 255", "grid, 64",
        "grid, 255"})
    void keepToTheErrorOnThinThings(String name, int parts) throws Exception {
        Scene scene = Scenes.parse(switch (name) {
            case "slats" -> slats(.03);
            case "narrow slats" -> slats(.004);
            case "dust" -> dust();
            default -> grid();
        }).scene();
        double error = render(scene, new Sampling.Within(1.0 / parts)).rmse(converged(name, scene));
        assertTrue(error <= 1.2 / parts, error * parts + " times the aim");
    }

    @Test
    void aNeedleOfAPixelsWidthHasNoGaps() throws Exception {
        Scene scene = Scenes.parse("""
                size 160 120
                camera 0 0 6 0 0 0 0 1 0 45
                ambient 1 1 1
                maxverts 4
                vertex -.4 -2 0
                vertex -.36 -2 0
                vertex .44 2 0
                vertex .4 2 0
                tri 0 1 2
                tri 0 2 3
                """).scene();
        Canvas exact = render(scene, new Sampling.Lattice(400, 1)), auto = render(scene, new Sampling.Within(1 / 255.0));
        for (int y = 13; y < 107; y++) {
            double wanted = 0, found = 0;
            for (int x = 0; x < 160; x++) {
                wanted += value(exact, x, y, 0);
                found += value(auto, x, y, 0);
            }
            assertEquals(wanted, found, .2 * wanted, "row " + y);
        }
    }
}
