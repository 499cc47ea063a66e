package raytracer.parser;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.scene.Camera;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/** A valid scene file. */
class SceneParserTest {

    /** Before any material command. */
    private static final Material DEFAULT = new Material(Colour.BLACK, Colour.BLACK, Colour.BLACK, 1);

    private static final String HEAD = "size 4 3\ncamera 0 0 5 0 0 0 0 1 0 45\n";

    private static Scene parse(String text) throws Exception {
        return Scenes.parse(text).scene();
    }

    private static double number(String word) throws Exception {
        return parse(HEAD + "shininess " + word + "\nplane 0 0 0 0 0 1").shapes().get(0).material().shininess();
    }

    @Test
    void sizeAndCameraAreRequiredAndAllElseHasDefaults() throws Exception {
        Scene scene = parse(HEAD);
        assertEquals(4, scene.width());
        assertEquals(3, scene.height());
        assertEquals(new Camera(new Vector(0, 0, 5), new Vector(0, 0, 0), new Vector(0, 1, 0), 45), scene.camera());
        assertEquals(1, scene.maxDepth());
        assertEquals("output.png", scene.output());
        assertTrue(scene.shapes().isEmpty());
        assertTrue(scene.lights().isEmpty());
    }

    @Test
    void eachShapeTakesTheMaterialInForceWhereItIsDeclared() throws Exception {
        List<Shape> shapes = parse(HEAD + """
                sphere 1 2 3 4
                ambient .1 .2 .3
                diffuse .4 .5 .6
                specular .7 .8 .9
                shininess 12
                plane 1 2 3 0 0 -2
                shininess -1
                sphere 0 0 0 1
                """).shapes();
        Material second = new Material(
                new Colour(.1, .2, .3), new Colour(.4, .5, .6), new Colour(.7, .8, .9), 12);
        assertEquals(List.of(
                new Shape.Sphere(new Vector(1, 2, 3), 4, DEFAULT),
                new Shape.Plane(new Vector(1, 2, 3), new Vector(0, 0, -2), second),
                new Shape.Sphere(new Vector(0, 0, 0), 1,
                        new Material(second.ambient(), second.diffuse(), second.specular(), -1))), shapes);
    }

    @Test
    void lightsAndMaxDepthHoldForTheWholeSceneWhereverTheyStand() throws Exception {
        Scene scene = parse("sphere 0 0 0 1\nmaxdepth 7\npoint 1 2 3 .1 .2 .3\n" + HEAD + "directional 4 5 6 1 1 1\n");
        assertEquals(7, scene.maxDepth());
        assertEquals(List.of(
                new Light.Point(new Vector(1, 2, 3), new Colour(.1, .2, .3)),
                new Light.Directional(new Vector(4, 5, 6), new Colour(1, 1, 1))), scene.lights());
    }

    @Test
    void trianglesShareVerticesAndFormOneRunPerMaterialAndStretch() throws Exception {
        Scene scene = parse(HEAD + """
                maxverts 4
                vertex 0 0 0
                vertex 1 0 0
                vertex 0 1 0
                tri 0 1 2
                vertex 7 8 9
                tri 1 3 2
                diffuse 1 0 0
                tri 2 1 0
                sphere 0 0 0 1
                tri 0 1 3
                """);
        Material red = new Material(Colour.BLACK, new Colour(1, 0, 0), Colour.BLACK, 1);
        assertEquals(List.of(
                new Shape.Triangles(0, 2, DEFAULT),
                new Shape.Triangles(2, 1, red),
                new Shape.Sphere(new Vector(0, 0, 0), 1, red),
                new Shape.Triangles(3, 1, red)), scene.shapes());
        assertEquals(4, scene.mesh().triangles());
        assertEquals(new Vector(7, 8, 9), scene.mesh().corner(1, 1));
    }

    @Test
    void shapesOfEqualMaterialShareOneObject() throws Exception {
        List<Shape> shapes = parse(HEAD + """
                diffuse 1 0 0
                sphere 0 0 0 1
                diffuse 1.0 0 -0
                shininess 1
                sphere 0 0 0 2
                """).shapes();
        assertNotSame(shapes.get(0), shapes.get(1));
        assertTrue(shapes.get(1).material().diffuse().blue() == 0);
        List<Shape> same = parse(HEAD + "diffuse 1 0 0\nsphere 0 0 0 1\ndiffuse 1.0 0 0\nsphere 0 0 0 2\n").shapes();
        assertSame(same.get(0).material(), same.get(1).material());
    }

    @Test
    void commentsBlankLinesTabsCrLfAndByteOrderMarkAreFine() throws Exception {
        Scene scene = parse("\uFEFF# sphere 1 2 3\r\n\r\n \t \r\n\tsize\t4  3 # 5\r\n#\r\n  # x\r\n"
                + "camera 0 0 5 0 0 0 0 1 0 45 #end\r\noutput a.png\r\nsphere 1 2 3 4 #\n");
        assertEquals(4, scene.width());
        assertEquals("a.png", scene.output());
        assertEquals(1, scene.shapes().size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"my picture.png", "bild-\u00E4\u4E2D.png", "a#b.png"})
    void anOutputNameMayHoldBlanksAndAnyCharacter(String name) throws Exception {
        assertEquals(name, parse(HEAD + "output   " + name + " \t # a comment\n").output());
    }

    @Test
    void theLastLineNeedsNoLineBreak() throws Exception {
        assertEquals(1, parse(HEAD + "sphere 0 0 0 1").shapes().size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "+1", "-.5", "2.", "1e-3", "-0", "007", "1E+2", "0.1", ".3", "123456.789",
        "9007199254740993", "9007199254740992.5", "1e22", "1e23", "8.5e-23", "4.9e-324", "2e-324", "1.7976931348623157e308",
        "2.2250738585072011e-308", "0.30000000000000004", "179769313486231570000000000000000000000e270",
        "0.000000000000000000000000000000000001", "3.14159265358979323846264338327950288", "1e-400",
        "000000000000000000000000000000000000001.5", "6.02214076e23", "0e999999999999"})
    void numbersAreReadAsTheNearestDouble(String word) throws Exception {
        assertEquals(Double.doubleToRawLongBits(Double.parseDouble(word)), Double.doubleToRawLongBits(number(word)));
    }

    @Test
    void randomNumbersAreReadAsTheNearestDouble() throws Exception {
        java.util.Random random = new java.util.Random(1);
        StringBuilder text = new StringBuilder(HEAD);
        double[] expected = new double[3 * 20_000];
        for (int i = 0; i < expected.length; i++) {
            String digits = Long.toString(random.nextLong() >>> 1 + random.nextInt(62));
            int point = random.nextInt(digits.length() + 1);
            String word = (random.nextBoolean() ? "-" : "") + digits.substring(0, point) + "." + digits.substring(point)
                    + (random.nextBoolean() ? "e" + (random.nextInt(80) - 40) : "");
            expected[i] = Double.parseDouble(word);
            text.append(i == 0 ? "maxverts 99999999\n" : "").append(i % 3 == 0 ? "vertex" : "").append(' ').append(word);
            text.append(i % 3 == 2 ? "\n" : "");
        }
        for (int v = 0; v + 2 < expected.length / 3; v += 3) {
            text.append("tri ").append(v).append(' ').append(v + 1).append(' ').append(v + 2).append('\n');
        }
        Scene scene = parse(text.toString());
        for (int t = 0; t < scene.mesh().triangles(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                Vector v = scene.mesh().corner(t, corner);
                int i = 3 * (3 * t + corner);
                assertArrayEquals(new double[] {expected[i], expected[i + 1], expected[i + 2]},
                        new double[] {v.x(), v.y(), v.z()}, "vertex " + (3 * t + corner));
            }
        }
    }

    @Test
    void linesMayEndAnywhereInTheReadersBuffer() throws Exception {
        String filler = "#" + "x".repeat(1000) + "\n";
        for (int extra = 0; extra < 60; extra++) {
            String text = HEAD + filler.repeat(65) + "#" + "y".repeat(300 + extra) + "\nsphere 1 2 3 4\nsphere 5 6 7 8\n";
            assertEquals(2, parse(text).shapes().size(), "extra " + extra);
        }
    }

    @Test
    void maxVertsReservesNothing() throws Exception {
        assertEquals(0, parse(HEAD + "maxverts 2000000000\n").mesh().triangles());
    }

    @Test
    @DisplayName("warnings name what the author may not have meant")
    void warnings() throws Exception {
        String light = "point 0 0 5 1 1 1\n";
        assertAll(
                () -> assertEquals(List.of(), Scenes.warnings(HEAD + light + "sphere 0 0 0 1\n")),
                () -> assertEquals(
                        List.of("test.scene:4:1: warning: 'maxverts' declares 5 vertices, but 1 follow"),
                        Scenes.warnings(HEAD + light + "maxverts 5\nvertex 0 0 0\nsphere 0 0 0 1\n")),
                () -> assertEquals(
                        List.of("test.scene:8:1: warning: 2 triangles have no area and are never seen; this is the first"),
                        Scenes.warnings(HEAD + light + "maxverts 3\nvertex 0 0 0\nvertex 1 1 1\nvertex 2 2 2\n"
                                + "tri 0 1 2\ntri 0 0 1\n")));
    }
}
