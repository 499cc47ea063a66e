package raytracer.speed;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.concurrent.Callable;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import raytracer.image.Image;

/**
 * A scene to be measured, and how its right picture is known: by the CRC-32 of the bytes that the exact judge
 * computes ({@code src/test/scripts/regenerate-speed-pictures}), three a pixel from the top left.
 */
record Subject(String name, Callable<String> source) {

    private static final Path CHECKSUMS = Path.of("src", "test", "resources", "speed-pictures.properties");

    /** Sides of the mountains in squares: 10^3 to 10^6.5 triangles in steps of a factor of 10^0.5. */
    private static final int[] SIDES = {22, 40, 71, 126, 224, 398, 707, 1257};

    static List<Subject> six() {
        return List.of(
                new Subject("final", () -> Files.readString(Path.of("scenes", "final.scene"))),
                new Subject("seeds", SpeedScenes::seeds),
                new Subject("lattice", SpeedScenes::lattice),
                new Subject("mountains-398", () -> SpeedScenes.mountains(398)),
                new Subject("knot", SpeedScenes::knot),
                new Subject("corridor", SpeedScenes::corridor));
    }

    static List<Subject> mountains() {
        List<Subject> all = new ArrayList<>();
        for (int side : SIDES) {
            all.add(new Subject("mountains-" + side, () -> SpeedScenes.mountains(side)));
        }
        return all;
    }

    static List<Subject> all() {
        List<Subject> all = new ArrayList<>(six());
        mountains().stream().filter(m -> all.stream().noneMatch(s -> s.name.equals(m.name))).forEach(all::add);
        return all;
    }

    String text() {
        try {
            return source.call();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    /** Whether a picture is the exact one, bit for bit. */
    boolean isRight(Image image) throws IOException {
        Properties known = new Properties();
        try (var in = Files.newBufferedReader(CHECKSUMS)) {
            known.load(in);
        }
        return checksum(image.toBufferedImage()).equals(known.getProperty(name));
    }

    private static String checksum(BufferedImage image) {
        CRC32 crc = new CRC32();
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                int rgb = image.getRGB(x, y);
                crc.update(rgb >> 16);
                crc.update(rgb >> 8);
                crc.update(rgb);
            }
        }
        return Long.toHexString(crc.getValue());
    }

    /** {@code write FOLDER} writes all scenes into a folder; {@code checksums FOLDER} prints those of its pictures. */
    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[1]);
        for (Subject subject : all()) {
            if (args[0].equals("write")) {
                Files.writeString(folder.resolve(subject.name + ".scene"), subject.text());
            } else {
                BufferedImage picture = ImageIO.read(folder.resolve(subject.name + ".png").toFile());
                System.out.println(subject.name + "=" + checksum(picture));
            }
        }
    }
}
