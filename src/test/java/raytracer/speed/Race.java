package raytracer.speed;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * The same picture by this program and by others, in turns, whole processes: what {@code src/test/scripts/race} runs.
 * SCENE [SAMPLES [ROUNDS]].
 */
final class Race {

    private Race() { }

    public static void main(String[] args) throws Exception {
        int samples = args.length > 1 ? Integer.parseInt(args[1]) : 1, rounds = args.length > 2 ? Integer.parseInt(args[2]) : 3;
        Path folder = Files.createTempDirectory("race");
        Peer.Job job = Peer.Job.of(Path.of(args[0]), samples, folder);
        List<Peer> peers = new ArrayList<>();
        for (Peer peer : Peer.all()) {
            if (peer.isThere(job)) {
                peers.add(peer);
            } else {
                System.out.println(peer.name() + " is not installed and left out");
            }
        }
        double[][] millis = new double[peers.size()][rounds];
        for (int round = 0; round < rounds; round++) {
            for (int k = 0; k < peers.size(); k++) {
                millis[k][round] = peers.get(k).run(job);
            }
        }
        System.out.printf(Locale.ROOT, "%s %dx%d, %d samples a pixel, whole processes on %d cores, medians of %d rounds%n",
                args[0], job.scene().width(), job.scene().height(), samples * samples,
                Runtime.getRuntime().availableProcessors(), rounds);
        for (int k = 0; k < peers.size(); k++) {
            System.out.printf(Locale.ROOT, "%-18s %8.0f ms  %5.2f times ours%n", peers.get(k).name(), median(millis[k]),
                    median(millis[k]) / median(millis[0]));
        }
        try (var files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(folder);
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
