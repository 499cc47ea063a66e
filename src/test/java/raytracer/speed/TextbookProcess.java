package raytracer.speed;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import raytracer.image.Image;
import raytracer.parser.SceneParser;
import raytracer.scene.Scene;
import raytracer.tracer.Textbook;

/** A {@link Textbook} as a program of its own, on all cores: SCENE OUT.png float|double EPSILON SAMPLES. */
final class TextbookProcess {

    private TextbookProcess() { }

    public static void main(String[] args) throws Exception {
        System.setProperty("java.awt.headless", "true");
        Scene scene;
        try (InputStream in = Files.newInputStream(Path.of(args[0]))) {
            scene = SceneParser.parse(args[0], in).scene();
        }
        int samples = Integer.parseInt(args[4]);
        Image image = new Image(scene.width(), scene.height());
        int threads = Runtime.getRuntime().availableProcessors();
        List<Thread> workers = new ArrayList<>();
        for (int i = 0; i < threads; i++) {
            int first = i;
            workers.add(new Thread(() -> new Textbook(scene, args[2].equals("float"), Double.parseDouble(args[3]))
                    .render(image, first, threads, samples)));
            workers.get(i).start();
        }
        for (Thread worker : workers) {
            worker.join();
        }
        ImageIO.write(image.toBufferedImage(), "png", Path.of(args[1]).toFile());
        System.exit(0);
    }
}
