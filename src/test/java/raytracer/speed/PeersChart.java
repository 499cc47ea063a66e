package raytracer.speed;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracer.chart.Figure;
import raytracer.chart.Origin;
import raytracer.chart.Panel;

/**
 * Speed against accuracy of whole programs: {@code mvn test -Dtest=PeersChart}, after {@code mvn package}, with g++ and
 * Embree. Each renders the same picture, one sample a pixel, in a process of its own; pixels are compared with the exact
 * picture. POV-Ray's and Tachyon's highlights are Phong's and their mirrors have no colour, so no pixel of theirs can be
 * told to be wrong: they are in the race only.
 */
class PeersChart {

    private static final Path SITE = Path.of("src", "site");
    private static final int ROUNDS = 5;

    /** Where no wrong pixel is drawn: half of one. */
    private static final double NONE = .5;

    @TempDir
    private Path folder;

    /** @param series its colour in the chart */
    private record Entry(Peer peer, int series, String picture) { }

    private static List<Entry> entries() {
        return List.of(
                new Entry(Peer.all().get(0), 4, "ours.png"),
                new Entry(Peer.textbook("float, eps 1e-3", "float", 1e-3), 0, "textbook.png"),
                new Entry(Peer.textbook("float, eps 1e-4", "float", 1e-4), 0, "textbook.png"),
                new Entry(Peer.textbook("double, eps 1e-6", "double", 1e-6), 2, "textbook.png"),
                new Entry(Peer.textbook("double, eps 1e-9", "double", 1e-9), 2, "textbook.png"),
                new Entry(Peer.embree("ray"), 3, "embree.ppm"),
                new Entry(Peer.embree("packet"), 3, "embree.ppm"));
    }

    @Test
    void wholeProgramsOnThreeScenes() throws Exception {
        List<String> csv = new ArrayList<>(List.of("# " + Origin.text(), "scene,program,median ms,fastest,slowest,wrong pixels"));
        Figure figure = new Figure("Whole programs: speed against accuracy", Origin.text(), 1, 720, 330);
        figure.add(panel("final", "final.scene: a mesh, spheres, a plane, 8 mirrors deep; 640x480", csv));
        figure.add(panel("sunflower", "sunflower.scene: 900 spheres; 640x480", csv));
        figure.add(panel("planet", "planet.scene: spheres of radius .3 to 6,371,000; 640x400", csv));
        figure.explain(4, "ours");
        figure.explain(0, "textbook in float");
        figure.explain(2, "textbook in double");
        figure.explain(3, "Embree, in float");
        figure.explainBars("fastest and slowest");
        figure.explainBand("none wrong");
        figure.explainFront("nothing measured is faster and as accurate");
        csv.forEach(System.out::println);
        Files.writeString(SITE.resolve("peers.svg"), figure.svg());
        Files.write(SITE.resolve("peers.csv"), csv, StandardCharsets.UTF_8);
    }

    private Panel panel(String name, String title, List<String> csv) throws IOException, InterruptedException {
        Path own = Files.createDirectory(folder.resolve(name));
        Peer.Job job = Peer.Job.of(Path.of("scenes", name + ".scene"), 1, own);
        List<Entry> entries = entries();
        Assumptions.assumeTrue(entries.stream().allMatch(e -> e.peer.isThere(job)), "g++ or Embree is not installed");
        double[][] millis = new double[entries.size()][ROUNDS];
        int[] wrong = new int[entries.size()];
        BufferedImage exact = ImageIO.read(Path.of("scenes", name + ".png").toFile());
        for (int round = 0; round < ROUNDS; round++) {
            for (int k = 0; k < millis.length; k++) {
                millis[k][round] = entries.get(k).peer.run(job);
                wrong[k] = differing(job.folder().resolve(entries.get(k).picture), exact);
            }
        }
        Panel panel = new Panel(title, "ms, whole process", "wrong pixels", NONE);
        for (int k = 0; k < millis.length; k++) {
            double[] sorted = millis[k].clone();
            Arrays.sort(sorted);
            Entry e = entries.get(k);
            panel.point(e.peer.name(), e.series, sorted[ROUNDS / 2], sorted[0], sorted[ROUNDS - 1], wrong[k]);
            csv.add(String.format(Locale.ROOT, "%s,%s,%.0f,%.0f,%.0f,%d", name, e.peer.name().replace(",", ""),
                    sorted[ROUNDS / 2], sorted[0], sorted[ROUNDS - 1], wrong[k]));
        }
        return panel;
    }

    private static int differing(Path file, BufferedImage exact) throws IOException {
        int count = 0;
        if (file.toString().endsWith(".png")) {
            BufferedImage image = ImageIO.read(file.toFile());
            for (int i = 0; i < exact.getWidth() * exact.getHeight(); i++) {
                int x = i % exact.getWidth(), y = i / exact.getWidth();
                count += image.getRGB(x, y) != exact.getRGB(x, y) ? 1 : 0;
            }
            return count;
        }
        byte[] ppm = Files.readAllBytes(file);
        int start = ppm.length - 3 * exact.getWidth() * exact.getHeight();
        for (int i = 0; i < exact.getWidth() * exact.getHeight(); i++) {
            int at = start + 3 * i;
            int rgb = (ppm[at] & 255) << 16 | (ppm[at + 1] & 255) << 8 | ppm[at + 2] & 255;
            count += rgb != (exact.getRGB(i % exact.getWidth(), i / exact.getWidth()) & 0xFFFFFF) ? 1 : 0;
        }
        return count;
    }
}
