package raytracer.parser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A scene file that breaks the format. */
class SceneErrorTest {

    private static final String HEAD = "size 4 3\ncamera 0 0 5 0 0 0 0 1 0 45\n";
    private static final String MESH = HEAD + "maxverts 3\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

    private static List<Diagnostic> errors(String text) {
        return assertThrows(SceneException.class, () -> Scenes.parse(text)).errors();
    }

    /** Every row of the format's table, violated. */
    static Stream<Arguments> violations() {
        return Stream.of(
                // Numbers.
                of(HEAD + "sphere 1 2 x 4", 3, 12, "expected z of 'sphere' to be a decimal number, found 'x'"),
                of(HEAD + "shininess NaN", 3, 11, "expected s of 'shininess' to be a decimal number, found 'NaN'"),
                of(HEAD + "shininess Infinity", 3, 11,
                        "expected s of 'shininess' to be a decimal number, found 'Infinity'"),
                of(HEAD + "shininess 0x10", 3, 11, "expected s of 'shininess' to be a decimal number, found '0x10'"),
                of(HEAD + "shininess 1f", 3, 11, "expected s of 'shininess' to be a decimal number, found '1f'"),
                of(HEAD + "shininess 1d", 3, 11, "expected s of 'shininess' to be a decimal number, found '1d'"),
                of(HEAD + "shininess .", 3, 11, "expected s of 'shininess' to be a decimal number, found '.'"),
                of(HEAD + "shininess -", 3, 11, "expected s of 'shininess' to be a decimal number, found '-'"),
                of(HEAD + "shininess 1e", 3, 11, "expected s of 'shininess' to be a decimal number, found '1e'"),
                of(HEAD + "shininess e5", 3, 11, "expected s of 'shininess' to be a decimal number, found 'e5'"),
                of(HEAD + "shininess 1,5", 3, 11, "expected s of 'shininess' to be a decimal number with a point, as 1.5, found '1,5'"),
                of(HEAD + "shininess 1e999", 3, 11,
                        "expected s of 'shininess' to be within a double's range (1.8e308), found '1e999'"),
                // Lengths of which squares overflow or are lost.
                of(HEAD + "sphere 2e150 0 0 1", 3, 8, "expected x of 'sphere' to be from -1e150 to 1e150, found '2e150'"),
                of(HEAD + "sphere 0 0 0 1e151", 3, 14, "expected r of 'sphere' to be from 1e-150 to 1e150, found '1e151'"),
                of(HEAD + "sphere 0 0 0 6e-161", 3, 14,
                        "expected r of 'sphere' to be from 1e-150 to 1e150, found '6e-161'"),
                of(HEAD + "plane 0 -3e154 0 0 1 0", 3, 9,
                        "expected y of 'plane' to be from -1e150 to 1e150, found '-3e154'"),
                of(HEAD + "point 0 0 1e300 1 1 1", 3, 11,
                        "expected z of 'point' to be from -1e150 to 1e150, found '1e300'"),
                of(HEAD + "maxverts 1\nvertex 0 1e151 0", 4, 10,
                        "expected y of 'vertex' to be from -1e150 to 1e150, found '1e151'"),
                of(HEAD + "maxverts 3\nvertex 0 0 0\nvertex 1e-160 0 0\nvertex 0 1e-160 0\ntri 0 1 2", 7, 5,
                        "expected the corners of 'tri' to be 1e-150 or more apart, or equal"),
                of("size 4 3\ncamera 0 0 1e-160 0 0 0 0 1 0 45", 2, 8, "expected the eye (ex ey ez) and the point looked"
                        + " at (ax ay az) of 'camera' to differ by 1e-150 or more"),
                of("size 4 3\ncamera 0 0 1e154 0 0 0 0 1 0 45", 2, 12,
                        "expected ez of 'camera' to be from -1e150 to 1e150, found '1e154'"),
                // A number too many or too few.
                of(HEAD + "diffuse .5 .4", 3, 9, "expected 3 numbers after 'diffuse' (r g b), found 2"),
                of(HEAD + "diffuse", 3, 8, "expected 3 numbers after 'diffuse' (r g b), found 0"),
                of(HEAD + "diffuse .5 # .4 .3", 3, 9, "expected 3 numbers after 'diffuse' (r g b), found 1"),
                of(HEAD + "shininess 1 2 3", 3, 13, "expected 1 number after 'shininess' (s), found 3"),
                // Keywords.
                of(HEAD + "  spere 0 0 0 1", 3, 3, "expected a command, found 'spere'; did you mean 'sphere'?"),
                of(HEAD + "Plane 0 0 0 0 0 1", 3, 1, "expected a command, found 'Plane'; did you mean 'plane'?"),
                of(HEAD + "translate 1 2 3", 3, 1, "expected a command, found 'translate'; the format has no"
                        + " transformations: write coordinates out"),
                of(HEAD + "shadow", 3, 7, "expected true or false after 'shadow', found none"),
                of(HEAD + "shadow on", 3, 8, "expected 'shadow' to be true or false, found 'on'"),
                of(HEAD + "shadow true\nshadow false", 4, 1, "expected 'shadow' once, found it again (first on line 3)"),
                of("SIZE 4 3\ncamera 0 0 5 0 0 0 0 1 0 45\n", 1, 1, "expected a command, found 'SIZE'; did you mean 'size'?"),
                of(HEAD + "v 1 2 3", 3, 1, "expected a command, found 'v'; this is an OBJ file's: here it is 'maxverts n',"
                        + " 'vertex x y z', and 'tri i j k' from 0 on (README has a recipe)"),
                of(HEAD + "vn 1 2 3", 3, 1,
                        "expected a command, found 'vn'; triangles are flat, of one colour: use 'maxverts', 'vertex' and 'tri'"),
                of(HEAD + "triangle 1 2 3", 3, 1,
                        "expected a command, found 'triangle'; 'tri i j k' is one, of three vertices declared above"),
                of(HEAD + "colour 1 1 1", 3, 1,
                        "expected a command, found 'colour'; 'diffuse r g b' holds for the shapes after it"),
                of(HEAD + "Light 1 1 1", 3, 1,
                        "expected a command, found 'Light'; 'point x y z r g b' or 'directional x y z r g b'"),
                of(HEAD + "lens 1", 3, 1,
                        "expected a command, found 'lens'; the camera is a pinhole, and all is sharp: take the line out"),
                of(HEAD + "index 1.5", 3, 1,
                        "expected a command, found 'index'; nothing can be seen through: take the line out"),
                of(HEAD + "PushTransform", 3, 1, "expected a command, found 'PushTransform'; the format has no"
                        + " transformations: write coordinates out"),
                of(HEAD + "emission 1 1 1", 3, 1, "expected a command, found 'emission'; add its colour to 'ambient'"),
                of(HEAD + "cone 1\n".repeat(3), 3, 1, "expected a command, found 'cone' (on 3 lines)"),
                of(HEAD + "sphere\u00A0 0 .6 0 .6", 3, 1,
                        "expected a command, found 'sphere\u00A0' (with U+00A0); did you mean 'sphere'?"),
                of(HEAD + "shininess \u22123", 3, 11,
                        "expected s of 'shininess' to be a decimal number, found '\u22123' (with U+2212)"),
                // Files of other kinds.
                of("\u0000s\u0000i\u0000z", 1, 1, "expected UTF-8 text, found UTF-16; save the file as UTF-8"),
                of("s\u0000i\u0000z\u0000", 1, 1, "expected UTF-8 text, found UTF-16; save the file as UTF-8"),
                // size
                of("camera 0 0 5 0 0 0 0 1 0 45\n# and no more\n", 1, 1, "expected a 'size w h' command in the file, found none"),
                of(HEAD + "size 4 3", 3, 1, "expected 'size' once, found it again (first on line 1)"),
                of(HEAD.replace("4 3", "0 3"), 1, 6,
                        "expected w of 'size' to be a whole number from 1 to 2147483647, found '0'"),
                of(HEAD.replace("4 3", "4 -3"), 1, 8,
                        "expected h of 'size' to be a whole number from 1 to 2147483647, found '-3'"),
                of(HEAD.replace("4 3", "4.5 3"), 1, 6,
                        "expected w of 'size' to be a whole number from 1 to 2147483647, found '4.5'"),
                of(HEAD.replace("4 3", "4 3000000000"), 1, 8,
                        "expected h of 'size' to be a whole number from 1 to 2147483647, found '3000000000'"),
                // camera
                of("size 4 3", 1, 1,
                        "expected a 'camera ex ey ez ax ay az ux uy uz fov' command in the file, found none"),
                of(HEAD + "camera 0 0 5 0 0 0 0 1 0 45", 3, 1,
                        "expected 'camera' once, found it again (first on line 2)"),
                of("size 4 3\ncamera 1 2 3 1 2 3 0 1 0 45", 2, 8, "expected the eye (ex ey ez) and the point looked"
                        + " at (ax ay az) of 'camera' to differ, found them equal"),
                of("size 4 3\ncamera 0 0 5 0 0 0 0 0 0 45", 2, 20,
                        "expected ux uy uz of 'camera' to have a length, found 0 0 0"),
                of("size 4 3\ncamera 1 2 3 3 5 7 -2 -3 -4 45", 2, 20, "expected up (ux uy uz) of 'camera' to differ"
                        + " from the direction of view, found them parallel"),
                of(HEAD.replace("45", "0"), 2, 26,
                        "expected fov of 'camera' to be between 0 and 180 degrees, found '0'"),
                of(HEAD.replace("45", "180"), 2, 26,
                        "expected fov of 'camera' to be between 0 and 180 degrees, found '180'"),
                // output
                of(HEAD + "output", 3, 7, "expected a name after 'output', found none"),
                of(HEAD + "output # a.png", 3, 7, "expected a name after 'output', found none"),
                of(HEAD + "output a.png\noutput b.png", 4, 1,
                        "expected 'output' once, found it again (first on line 3)"),
                of(new String(new byte[] {'\n'}, StandardCharsets.UTF_8) + HEAD + "spher", 4, 1,
                        "expected a command, found 'spher'; did you mean 'sphere'?"),
                // maxdepth
                of(HEAD + "maxdepth 0", 3, 10,
                        "expected n of 'maxdepth' to be a whole number from 1 to 2147483647, found '0'"),
                of(HEAD + "maxdepth 2\nmaxdepth 2", 4, 1,
                        "expected 'maxdepth' once, found it again (first on line 3)"),
                // Colours.
                of(HEAD + "ambient -.1 0 0", 3, 9, "expected r of 'ambient' to be 0 or more, found '-.1'"),
                of(HEAD + "diffuse 0 -1 0", 3, 11, "expected g of 'diffuse' to be 0 or more, found '-1'"),
                of(HEAD + "specular 0 0 -1e-9", 3, 14, "expected b of 'specular' to be 0 or more, found '-1e-9'"),
                // Lights.
                of(HEAD + "directional 0 0 0 1 1 1", 3, 13,
                        "expected x y z of 'directional' to have a length, found 0 0 0"),
                of(HEAD + "directional 0 0 1 1 1 -1", 3, 23,
                        "expected b of 'directional' to be 0 or more, found '-1'"),
                of(HEAD + "point 0 0 1 -1 1 1", 3, 13, "expected r of 'point' to be 0 or more, found '-1'"),
                // Meshes.
                of(HEAD + "vertex 0 0 0", 3, 1, "expected 'maxverts' before the first 'vertex', found none"),
                of(HEAD + "maxverts -1", 3, 10,
                        "expected n of 'maxverts' to be a whole number from 0 to 2147483647, found '-1'"),
                of(HEAD + "maxverts 1\nmaxverts 1", 4, 1,
                        "expected 'maxverts' once, found it again (first on line 3)"),
                of(MESH + "vertex 0 0 1", 7, 1,
                        "expected at most 3 vertices ('maxverts' on line 3), found one more"),
                of(HEAD + "tri 0 0 0", 3, 5, "expected i of 'tri' to be a vertex declared above, of which there are"
                        + " none, found '0'"),
                of(MESH + "tri 0 1 3", 7, 9,
                        "expected k of 'tri' to be a vertex declared above, from 0 to 2, found '3'"),
                of(MESH + "tri 0 -1 2", 7, 7,
                        "expected j of 'tri' to be a vertex declared above, from 0 to 2, found '-1'"),
                of(MESH + "tri 0.5 1 2", 7, 5,
                        "expected i of 'tri' to be a vertex declared above, from 0 to 2, found '0.5'"),
                // Other shapes.
                of(HEAD + "sphere 0 0 0 0", 3, 14, "expected r of 'sphere' to be more than 0, found '0'"),
                of(HEAD + "sphere 0 0 0 -1", 3, 14, "expected r of 'sphere' to be more than 0, found '-1'"),
                of(HEAD + "plane 0 0 0 0 0 0", 3, 13, "expected nx ny nz of 'plane' to have a length, found 0 0 0"),
                // Columns count characters, not bytes.
                of(HEAD + "\u00E4\u4E2D 1", 3, 1,
                        "expected a command, found '\u00E4\u4E2D' (with U+00E4, U+4E2D)"),
                of("\uFEFFsize 4 x", 1, 8, "expected h of 'size' to be a decimal number, found 'x'"));
    }

    private static Arguments of(String text, int line, int column, String message) {
        return Arguments.of(text, line, column, message);
    }

    @ParameterizedTest(name = "{3}")
    @MethodSource("violations")
    void isRejectedWithPlaceExpectationAndFinding(String text, int line, int column, String message) {
        Diagnostic error = errors(text).get(0);
        assertEquals(message, error.message());
        assertEquals(line + ":" + column, error.line() + ":" + error.column());
    }

    @Test
    void showsTheLineWithACaretUnderThePlace() {
        assertEquals("""
                test.scene:3:10: expected 3 numbers after 'diffuse' (r g b), found 2
                \tdiffuse .5 .4
                \t        ^~~~~""", errors(HEAD + "\tdiffuse .5 .4\r\n").get(0).toString());
    }

    @Test
    void showsPartOfALongLine() {
        String[] lines = errors(HEAD + "sphere 1 2 3 4" + " ".repeat(500) + "5" + " ".repeat(500) + "#").get(0)
                .toString().split("\n");
        assertTrue(lines[1].length() <= 100);
        assertEquals('5', lines[1].charAt(lines[2].indexOf('^')));
    }

    @Test
    void reportsAllErrorsAtOnceAndCountsThoseBeyondTwenty() {
        SceneException e = assertThrows(SceneException.class, () -> Scenes.parse(HEAD + "sphere 0 0 0 0\n".repeat(25)));
        assertEquals(20, e.errors().size());
        assertEquals("5 more errors", e.rest());
        assertEquals(List.of(3L, 22L), List.of(e.errors().get(0).line(), e.errors().get(19).line()));
    }

    @Test
    void oneMistakeIsNotReportedAgainByWhatBuildsOnIt() {
        assertEquals(1, errors(HEAD + "maxverts x\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\ntri 0 1 2\n").size());
        assertEquals(1, errors(MESH.replace("vertex 1 0 0", "vertex 1 o 0") + "tri 0 1 2\n").size());
        assertEquals(1, errors("size 0 0\ncamera 0 0 5 0 0 0 0 1 0 45\n").size());
    }

    @Test
    void anEmptyFileLacksBothRequiredCommands() {
        assertEquals(List.of("1:1", "1:1"), errors("").stream().map(e -> e.line() + ":" + e.column()).toList());
    }

    @Test
    void aLineWithoutEndIsGivenUpSoon() {
        long[] read = {0};
        InputStream endless = new InputStream() {
            @Override
            public int read() {
                read[0]++;
                return '1';
            }

            @Override
            public int read(byte[] b, int off, int len) {
                java.util.Arrays.fill(b, off, off + len, (byte) '1');
                read[0] += len;
                return len;
            }
        };
        SceneException e = assertThrows(SceneException.class, () -> SceneParser.parse("endless", endless));
        assertEquals("endless:1:1: expected a line of at most 1048576 bytes, found a longer one",
                e.errors().get(0).toString());
        assertTrue(read[0] < 10_000_000);
    }

    @Test
    void anyBytesMeetAMessageAndNothingElse() throws Exception {
        Random random = new Random(5);
        byte[] valid = (MESH + "tri 0 1 2\ndiffuse .5 .5 .5\nsphere 0 0 0 1\noutput a b.png\nplane 0 0 0 0 1 0\n")
                .getBytes(StandardCharsets.UTF_8);
        int rejected = 0;
        for (int i = 0; i < 20_000; i++) {
            byte[] text = valid.clone();
            for (int edits = 1 + random.nextInt(8); edits > 0; edits--) {
                text[random.nextInt(text.length)] = (byte) random.nextInt(256);
            }
            text = java.util.Arrays.copyOf(text, random.nextInt(text.length + 1));
            try {
                SceneParser.parse("fuzz", new ByteArrayInputStream(text));
            } catch (SceneException e) {
                rejected++;
                for (Diagnostic error : e.errors()) {
                    assertTrue(error.line() >= 1 && error.column() >= 1 && !error.message().isBlank());
                }
            }
        }
        assertTrue(rejected > 10_000 && rejected < 20_000, rejected + " rejected");
    }
}
