package raytracer.chart;

import java.awt.image.BufferedImage;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import raytracer.image.Image;
import raytracer.parser.SceneParser;
import raytracer.render.Rendering;
import raytracer.scene.Scene;
import raytracer.tracer.Textbook;
import raytracer.tracer.Tracer;

/** Whole pictures of our own scenes on one thread: time against pixels that differ from the exact image. */
final class PictureChart {

    private static final double NONE = .5;

    private final String origin;
    private final List<String> csv;

    PictureChart(String origin, List<String> csv) {
        this.origin = origin;
        this.csv = csv;
    }

    void write(Path file) throws Exception {
        Figure figure = new Figure("Whole pictures: speed against accuracy", origin, 2, 380, 330);
        figure.add(panel("final", "final.scene: mesh, spheres, plane, 8 mirrors deep"));
        figure.add(panel("planet", "planet.scene: spheres of radius .3 to 6,371,000"));
        figure.add(panel("island", "island.scene: a mesh over a mirror"));
        figure.add(panel("sunflower", "sunflower.scene: 900 spheres"));
        figure.explain(0, "textbook in float");
        figure.explain(2, "in double");
        figure.explain(4, "ours");
        figure.explainBars("quartiles");
        figure.explainBand("none wrong");
        figure.explainFront("nothing measured is faster and as accurate");
        Files.writeString(file, figure.svg());
    }

    private Panel panel(String name, String title) throws Exception {
        Scene scene;
        try (InputStream in = Files.newInputStream(Path.of("scenes", name + ".scene"))) {
            scene = SceneParser.parse(name, in).scene();
        }
        BufferedImage exact = ImageIO.read(Path.of("scenes", name + ".png").toFile());
        Panel panel = new Panel(title, "ms per picture", "wrong pixels", NONE);
        Image image = new Image(scene.width(), scene.height());
        List<String> names = new ArrayList<>();
        List<Timing.Work> works = new ArrayList<>();
        List<Integer> wrong = new ArrayList<>();
        names.add("float, eps 1e-3");
        works.add(textbook(scene, image, true, 1e-3));
        names.add("float, eps 1e-4");
        works.add(textbook(scene, image, true, 1e-4));
        names.add("double, eps 1e-6");
        works.add(textbook(scene, image, false, 1e-6));
        names.add("double, eps 1e-9");
        works.add(textbook(scene, image, false, 1e-9));
        names.add("ours");
        Tracer tracer = Tracer.compile(scene);
        works.add(() -> {
            Rendering.of(tracer, 1, image).render();
            return image.rgb(0, 0);
        });
        for (Timing.Work work : works) {
            work.run();
            wrong.add(differing(image, exact));
        }
        Timing[] timings = Timing.of(works, 1e6, 2, 7);
        for (int k = 0; k < names.size(); k++) {
            panel.point(names.get(k), k == 4 ? 4 : k < 2 ? 0 : 2, timings[k].median(), timings[k].low(), timings[k].high(),
                    wrong.get(k));
            csv.add(String.format(Locale.ROOT, "pictures (ms),%s,%s,%.1f,%.1f,%.1f,%d,%d,", name, names.get(k).replace(",", ""),
                    timings[k].median(), timings[k].low(), timings[k].high(), scene.width() * scene.height(), wrong.get(k)));
        }
        return panel;
    }

    private static Timing.Work textbook(Scene scene, Image image, boolean inFloat, double epsilon) {
        Textbook textbook = new Textbook(scene, inFloat, epsilon);
        return () -> {
            textbook.render(image);
            return image.rgb(0, 0);
        };
    }

    private static int differing(Image image, BufferedImage exact) {
        int count = 0;
        for (int y = 0; y < image.toBufferedImage().getHeight(); y++) {
            for (int x = 0; x < image.toBufferedImage().getWidth(); x++) {
                count += image.rgb(x, y) != (exact.getRGB(x, y) & 0xFFFFFF) ? 1 : 0;
            }
        }
        return count;
    }
}
