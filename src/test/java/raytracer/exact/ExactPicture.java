package raytracer.exact;

import java.awt.image.BufferedImage;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import raytracer.parser.SceneParser;
import raytracer.scene.Scene;

/**
 * Renders a scene by the exact judge: SCENE OUT.png. What makes the reference pictures, by way of {@code
 * src/test/scripts/regenerate-references}; of the program's own code it uses the parser alone.
 */
public final class ExactPicture {

    private ExactPicture() { }

    public static void main(String[] args) throws Exception {
        System.setProperty("java.awt.headless", "true");
        Scene scene;
        try (InputStream in = Files.newInputStream(Path.of(args[0]))) {
            scene = SceneParser.parse(args[0], in).scene();
        }
        ExactRenderer judge = new ExactRenderer(scene);
        BufferedImage image = new BufferedImage(scene.width(), scene.height(), BufferedImage.TYPE_INT_RGB);
        AtomicInteger done = new AtomicInteger();
        IntStream.range(0, scene.height()).parallel().forEach(y -> {
            int[] row = IntStream.range(0, scene.width()).map(x -> judge.pixel(x, y)).toArray();
            synchronized (image) {
                image.setRGB(0, y, scene.width(), 1, row, 0, scene.width());
            }
            System.err.printf(Locale.ROOT, "\r%s: %3.0f %%", args[0], 100.0 * done.incrementAndGet() / scene.height());
        });
        System.err.println();
        ImageIO.write(image, "png", Path.of(args[1]).toFile());
    }
}
