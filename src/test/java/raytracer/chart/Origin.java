package raytracer.chart;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;

/** Where figures come from: machine, Java, commit and date. */
public final class Origin {

    private Origin() { }

    public static String text() throws IOException, InterruptedException {
        String cpu = "unknown processor";
        Path info = Path.of("/proc/cpuinfo");
        if (Files.exists(info)) {
            cpu = Files.readAllLines(info).stream().filter(l -> l.startsWith("model name")).findFirst()
                    .map(l -> l.substring(l.indexOf(':') + 2)).orElse(cpu);
        }
        return cpu + ", " + Runtime.getRuntime().availableProcessors() + " cores; Java " + Runtime.version() + "; commit "
                + commit() + "; " + LocalDate.now();
    }

    /** Charts and figures may have been drawn since: they make no difference to the next ones. */
    private static String commit() throws IOException, InterruptedException {
        String changed = git("status", "--porcelain", "--", "pom.xml", "src/main", "src/test", "scenes");
        return git("rev-parse", "--short", "HEAD") + (changed.isEmpty() ? "" : "-dirty");
    }

    private static String git(String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("git"));
        command.addAll(List.of(arguments));
        Process git = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        return git.waitFor() == 0 ? said : "unknown";
    }
}
