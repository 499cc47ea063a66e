package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.image.Comparison;

/** Comparing, as a teacher does. */
class CompareTest extends CommandLine {

    private static final String SCENE = "size 12 9\ncamera 0 0 5 0 0 0 0 1 0 45\npoint 3 4 5 .9 .9 .9\nambient .1 .1 .1\n"
            + "diffuse .6 .6 .6\nsphere 0 0 0 1\n";

    CompareTest() {
        super(SCENE);
    }

    private String render(String name) {
        String file = folder.resolve(name).toString();
        assertEquals(0, run(scene, "-o", file, "--quiet"), err());
        return file;
    }

    private static String changed(String file, int x, int y, int step) throws IOException {
        BufferedImage image = ImageIO.read(Path.of(file).toFile());
        image.setRGB(x, y, image.getRGB(x, y) + step);
        ImageIO.write(image, "png", Path.of(file).toFile());
        return file;
    }

    @Test
    void twoPicturesAreComparedAndNothingIsRendered() throws IOException {
        String one = render("one.png"), two = changed(render("two.png"), 3, 2, 7);
        assertEquals(0, run(one, "--compare", one));
        assertEquals(3, run(two, "--compare", one, "--diff", folder.resolve("d.png").toString()));
        assertTrue(out().contains("1 of 108 pixels differ from " + one + ", by at most 7 of 255 at (3, 2)"), out());
        assertFalse(err().contains("--explain"), "of no scene: " + err());
        assertTrue(Files.exists(folder.resolve("d.png")));
        assertFalse(Files.exists(folder.resolve("two-diff.png")));
    }

    @Test
    void eachIsComparedWithItsOwnInAFolder() throws IOException {
        Files.createDirectory(folder.resolve("solutions"));
        render("solutions/a.png");
        changed(render("solutions/b.png"), 5, 5, 1);
        String b = Files.copy(Path.of(render("b.png")), folder.resolve("hand-in.png")).resolveSibling("b.png").toString();
        String own = file("a.scene", SCENE + "output target/compare-test.png\n");
        assertEquals(3, run(own, b, "--compare", folder.resolve("solutions").toString(), "--quiet"), err());
        assertEquals(3, out().lines().count(), out());
        assertTrue(out().lines().anyMatch(l -> l.startsWith(own + ": equals ") && l.contains("solutions/a.png")), out());
        assertTrue(out().lines().anyMatch(l -> l.startsWith(b + ": 1 of 108 pixels differ from ")), out());
        assertTrue(out().endsWith("2 compared: 1 as they should be, 1 different, 0 failed\n"), out());
        assertFalse(Files.exists(Path.of("target", "compare-test.png")), "no picture is written");
        assertTrue(Files.exists(folder.resolve("b-diff.png")));
    }

    @Test
    void aClassIsGradedWhateverItsOutputsAreCalled() throws IOException {
        Files.createDirectory(folder.resolve("ann"));
        Files.createDirectory(folder.resolve("bob"));
        Files.createDirectory(folder.resolve("pictures"));
        String solution = render("solution.png"), stats = folder.resolve("s.json").toString();
        String right = file("ann/hand-in.scene", SCENE + "output hand-in.png\n");
        String wrong = file("bob/hand-in.scene", SCENE.replace(".6", ".7") + "output hand-in.png\n");
        String broken = file("broken.scene", SCENE + "spher\nspher 1\nsphere 1\n"), none = folder.resolve("none.scene").toString();
        assertEquals(3, run(right, wrong, broken, none, "--compare", solution, "--stats", stats), err());
        List<String> lines = out().lines().toList();
        assertEquals(right + ": equals " + solution + " in every pixel", lines.get(0));
        assertTrue(lines.get(1).startsWith(wrong + ": ") && lines.get(1).endsWith("; see " + folder.resolve("bob/hand-in-diff.png")), out());
        assertEquals(broken + ": not read: 2 errors", lines.get(2));
        assertEquals(none + ": not compared: cannot read the scene: no such file or directory", lines.get(3));
        assertEquals("4 compared: 1 as they should be, 1 different, 2 failed", lines.get(4));
        assertFalse(Files.exists(Path.of("hand-in.png")), "no picture is written");
        String json = Files.readString(Path.of(stats));
        assertEquals(4, json.lines().count(), json);
        assertTrue(json.startsWith("[{") && json.contains("\"failed\": \"not read: 2 errors\"") && json.contains("\"differing\": 0"), json);
    }

    @Test
    void picturesOfSeveralScenesGoIntoAFolderIfThatIsAskedFor() throws IOException {
        Files.createDirectory(folder.resolve("pictures"));
        String other = file("b.scene", SCENE);
        assertEquals(0, run(scene, other, "-o", folder.resolve("pictures").toString(), "--quiet"), err());
        assertTrue(Files.exists(folder.resolve("pictures/a.png")) && Files.exists(folder.resolve("pictures/b.png")));
        assertEquals(0, run(scene, "-o", folder + "/pictures/", "--compare", folder.resolve("pictures/b.png").toString()), err());
        assertEquals(2, run(scene, other, "-o", folder.resolve("none").toString()));
        assertTrue(err().contains("expected -o to name a folder that is there, for 2 scenes"), err());
    }

    @Test
    void aReferenceThatIsDamagedIsSaidToBe() throws IOException {
        String one = render("one.png");
        byte[] bytes = Files.readAllBytes(Path.of(one));
        Path half = Files.write(folder.resolve("half.png"), java.util.Arrays.copyOf(bytes, bytes.length / 2));
        assertEquals(1, run(scene, "-o", picture, "--compare", half.toString()));
        assertTrue(err().contains("cannot read the picture " + half + ": it is damaged") && !err().contains("Exception"), err());
    }

    @Test
    void whatIsBeyondTheToleranceIsCountedAndShown() throws IOException {
        String one = render("one.png"), two = changed(changed(render("two.png"), 3, 2, 7), 10, 8, 2);
        assertEquals(3, run(two, "--compare", one, "--tolerance", "3"));
        assertTrue(out().contains("2 of 108 pixels differ") && out().contains("; 1 by more than the tolerance of 3;"), out());
        BufferedImage shown = ImageIO.read(folder.resolve("two-diff.png").toFile());
        assertEquals(255, shown.getRGB(3, 2) >> 16 & 255, "beyond");
        assertTrue((shown.getRGB(10, 8) >> 16 & 255) < 64, "within");
    }

    @Test
    void aSinglePixelIsSeenEvenRedOnRed() {
        BufferedImage dark = new BufferedImage(9, 9, BufferedImage.TYPE_INT_RGB), dotted =
                new BufferedImage(9, 9, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 81; i++) {
            dark.setRGB(i % 9, i / 9, 0x600000);
            dotted.setRGB(i % 9, i / 9, i == 40 ? 0x800000 : 0x600000);
        }
        BufferedImage shown = Comparison.of(dotted, dark, 0).difference();
        int around = shown.getRGB(0, 0) & 0xFFFFFF;
        assertEquals(around & 255, around >> 16, "grey elsewhere");
        assertTrue((shown.getRGB(4, 4) >> 16 & 255) > 200 && (shown.getRGB(4, 4) >> 8 & 255) > 100, "bright");
        assertEquals(9, java.util.stream.IntStream.range(0, 81)
                .filter(i -> (shown.getRGB(i % 9, i / 9) & 0xFFFFFF) != around).count(), "with a rim");
    }

    @Test
    void figuresSayHow() throws IOException {
        String one = render("one.png"), stats = folder.resolve("s.json").toString();
        changed(one, 3, 2, 7);
        assertEquals(3, run(scene, "-o", picture, "--compare", one, "--stats", stats, "--quiet"));
        assertTrue(Files.readString(Path.of(stats)).contains("\"compare\": {\"reference\": \"" + one + "\", \"differing\": 1,"
                + " \"beyond\": 1, \"most\": 7, \"rmse\": 0.3889, \"x\": 3, \"y\": 2}"), Files.readString(Path.of(stats)));
    }

    @Test
    void anotherSizeIsADifferenceAndItsPixelsAreNotRead() throws IOException {
        // A header that announces 20,000 x 20,000 pixels, and no pixel.
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream png = new DataOutputStream(bytes);
        png.writeLong(0x89504E470D0A1A0AL);
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream ihdr = new DataOutputStream(header);
        ihdr.write("IHDR".getBytes(StandardCharsets.US_ASCII));
        ihdr.writeInt(20_000);
        ihdr.writeInt(20_000);
        ihdr.write(new byte[] {8, 2, 0, 0, 0});
        CRC32 crc = new CRC32();
        crc.update(header.toByteArray());
        png.writeInt(13);
        png.write(header.toByteArray());
        png.writeInt((int) crc.getValue());
        Path huge = Files.write(folder.resolve("huge.png"), bytes.toByteArray());
        assertEquals(3, run(scene, "-o", picture, "--compare", huge.toString()), err());
        assertTrue(out().contains("in size: 12x9, and that is 20000x20000"), out());
    }

    /** The picture, which is grey, in other kinds of PNG. */
    @ParameterizedTest(name = "a reference is compared by its samples: {0} components of {1} bits")
    @CsvSource({"1, 8", "2, 8", "3, 8", "4, 8", "1, 16", "2, 16", "3, 16", "4, 16"})
    void bySamples(int components, int bits) throws IOException {
        BufferedImage grey = ImageIO.read(Path.of(render("one.png")).toFile());
        boolean alpha = components % 2 == 0;
        int type = bits == 8 ? DataBuffer.TYPE_BYTE : DataBuffer.TYPE_USHORT;
        ColorModel colours = new ComponentColorModel(java.awt.color.ColorSpace.getInstance(components > 2
                ? java.awt.color.ColorSpace.CS_sRGB : java.awt.color.ColorSpace.CS_GRAY), alpha, false,
                alpha ? java.awt.Transparency.TRANSLUCENT : java.awt.Transparency.OPAQUE, type);
        WritableRaster samples = Raster.createInterleavedRaster(type, 12, 9, components, null);
        for (int i = 0; i < 108; i++) {
            for (int band = 0; band < components; band++) {
                int v = alpha && band == components - 1 ? 255 : grey.getRGB(i % 12, i / 12) & 255;
                samples.setSample(i % 12, i / 12, band, bits == 8 ? v : 257 * v);
            }
        }
        Path other = folder.resolve("other.png");
        assertTrue(ImageIO.write(new BufferedImage(colours, samples, false, null), "png", other.toFile()));
        assertEquals(0, run(scene, "-o", picture, "--compare", other.toString()), out());
    }

    @Test
    void aPaletteToo() throws IOException {
        BufferedImage grey = ImageIO.read(Path.of(render("one.png")).toFile());
        byte[] ramp = new byte[256];
        for (int i = 0; i < 256; i++) {
            ramp[i] = (byte) i;
        }
        BufferedImage palette = new BufferedImage(12, 9, BufferedImage.TYPE_BYTE_INDEXED,
                new java.awt.image.IndexColorModel(8, 256, ramp, ramp, ramp));
        for (int i = 0; i < 108; i++) {
            palette.getRaster().setSample(i % 12, i / 12, 0, grey.getRGB(i % 12, i / 12) & 255);
        }
        Path other = folder.resolve("other.png");
        assertTrue(ImageIO.write(palette, "png", other.toFile()));
        assertEquals(0, run(scene, "-o", picture, "--compare", other.toString()), out());
    }
}
