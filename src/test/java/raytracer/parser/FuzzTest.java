package raytracer.parser;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Scenes that are broken at random: bits flipped, cut, spliced, words exchanged. Some thousands in every build;
 * {@code mvn test -Dtest=FuzzTest -Dmutants=100000} for more.
 */
class FuzzTest {

    private static final int MUTANTS = Integer.getInteger("mutants", 4000);

    /** A second, for a text of some kilobytes. */
    private static final long MOST_NANOS = 1_000_000_000L;

    private static final int LONGEST = 4000;

    private static final String[] WORDS = {"size", "camera", "sphere", "plane", "tri", "vertex", "maxverts", "point",
        "directional", "ambient", "diffuse", "specular", "shininess", "maxdepth", "output", "0", "-0", "1e309", "-1e-400",
        "NaN", "Infinity", "0x10", "1_000", ".", "-", "+5", "1e", "2147483648", "99999999999999999999", "1.5", "#", "\t",
        "\u0000", "\uFEFF", "\r", "\u00E9", "\uD83D\uDE00", "'", "\"", "../x.png", "1,5", "tri 0 1 2", "maxverts 2000000000",
        "size 2147483647 2147483647", "sphere 0 0 0 1", "\n"};

    private final Random random = new Random(20261122);

    private static List<byte[]> seeds() throws IOException {
        List<byte[]> seeds = new ArrayList<>();
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".scene")).sorted().toList()) {
                byte[] text = Files.readAllBytes(file);
                seeds.add(Arrays.copyOf(text, Math.min(text.length, LONGEST)));
            }
        }
        return seeds;
    }

    @Test
    void longLinesAreToldAsFast() throws Exception {
        for (String word : List.of("1".repeat(1_000_000) + "x", "1.".repeat(500_000), "1e".repeat(500_000), "x".repeat(1_000_000))) {
            byte[] text = ("size 4 3\nsphere " + word + " 0 0 1\n").getBytes(StandardCharsets.UTF_8);
            long start = System.nanoTime();
            try {
                SceneParser.parse("long.scene", new ByteArrayInputStream(text));
                fail("no number: " + word.substring(0, 9));
            } catch (SceneException e) {
                assertTrue(System.nanoTime() - start < MOST_NANOS, e.getMessage());
            }
        }
    }

    @Test
    void isToldOrParsedButNeverAFaultAndNeverSlow() throws Exception {
        List<byte[]> seeds = seeds();
        int refused = 0, parsed = 0;
        for (int i = 0; i < MUTANTS; i++) {
            byte[] text = mutant(seeds);
            long start = System.nanoTime();
            try {
                ParsedScene scene = SceneParser.parse("fuzz.scene", new ByteArrayInputStream(text));
                assertTrue(scene.scene().width() > 0 && scene.scene().height() > 0);
                parsed++;
            } catch (SceneException e) {
                assertFalse(e.errors().isEmpty(), () -> show(text));
                e.errors().forEach(error -> assertTrue(error.toString().matches("(?s)fuzz\\.scene:\\d+:\\d+: .+"),
                        () -> error + "\n" + show(text)));
                refused++;
            } catch (RuntimeException | Error e) {
                fail("mutant " + i + ": " + e + "\n" + show(text), e);
            }
            long nanos = System.nanoTime() - start;
            assertTrue(nanos < MOST_NANOS, () -> nanos / 1e9 + " s\n" + show(text));
        }
        assertTrue(refused > MUTANTS / 4 && parsed > MUTANTS / 100, refused + " refused, " + parsed + " parsed");
    }

    private byte[] mutant(List<byte[]> seeds) {
        byte[] text = seeds.get(random.nextInt(seeds.size())).clone();
        for (int times = 1 + random.nextInt(4); times > 0 && text.length > 0; times--) {
            text = switch (random.nextInt(6)) {
                case 0 -> flipped(text);
                case 1 -> Arrays.copyOf(text, random.nextInt(text.length));
                case 2 -> spliced(text, seeds.get(random.nextInt(seeds.size())));
                case 3 -> inserted(text, WORDS[random.nextInt(WORDS.length)]);
                case 4 -> inserted(text, " " + WORDS[random.nextInt(WORDS.length)] + " ");
                default -> without(text);
            };
        }
        return text;
    }

    private byte[] flipped(byte[] text) {
        text[random.nextInt(text.length)] ^= (byte) (1 << random.nextInt(8));
        return text;
    }

    private byte[] spliced(byte[] a, byte[] b) {
        int at = random.nextInt(a.length), from = random.nextInt(b.length);
        byte[] text = Arrays.copyOf(a, at + b.length - from);
        System.arraycopy(b, from, text, at, b.length - from);
        return text;
    }

    private byte[] inserted(byte[] text, String word) {
        byte[] bytes = word.getBytes(StandardCharsets.UTF_8);
        int at = random.nextInt(text.length + 1);
        byte[] longer = Arrays.copyOf(text, text.length + bytes.length);
        System.arraycopy(text, at, longer, at + bytes.length, text.length - at);
        System.arraycopy(bytes, 0, longer, at, bytes.length);
        return longer;
    }

    private byte[] without(byte[] text) {
        int at = random.nextInt(text.length), count = Math.min(text.length - at, 1 + random.nextInt(20));
        byte[] shorter = Arrays.copyOf(text, text.length - count);
        System.arraycopy(text, at + count, shorter, at, text.length - at - count);
        return shorter;
    }

    private static String show(byte[] text) {
        return new String(text, StandardCharsets.UTF_8);
    }
}
