package raytracer.speed;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import raytracer.parser.SceneParser;
import raytracer.scene.Scene;

/**
 * A renderer of the same scenes: whole processes, from the scene's file to the picture's.
 *
 * @param needs    what must be there; {@link #isThere} tells whether it is
 * @param commands the process that renders a picture of so many samples along a pixel's side
 */
record Peer(String name, String needs, Commands commands) {

    /** Of a peer: the arguments of its process. */
    interface Commands {
        List<String> of(Job job) throws IOException;
    }

    /**
     * What is to be rendered: a scene in files of every language, and where pictures go.
     *
     * @param samples along a pixel's side
     */
    record Job(Path folder, Scene scene, int samples) {

        static Job of(Path sceneFile, int samples, Path folder) throws IOException, InterruptedException {
            Path file = folder.resolve("race.scene");
            Files.copy(sceneFile, file);
            Scene scene;
            try (InputStream in = Files.newInputStream(file)) {
                scene = SceneParser.parse(file.toString(), in).scene();
            } catch (raytracer.parser.SceneException e) {
                throw new IOException(e.errors().get(0).toString(), e);
            }
            Files.writeString(folder.resolve("race.pov"), PovScene.of(scene));
            Files.writeString(folder.resolve("race.dat"), TachyonScene.of(scene));
            Path source = Path.of("src", "test", "peers", "embree.cpp");
            if (isThere("g++")) {
                compile("g++", "-O3", "-march=native", "-o", folder.resolve("embree").toString(), source.toString(),
                        "-lembree3", "-lpthread");
            }
            if (isThere("javac")) {
                compile("javac", "-cp", SUNFLOW, "-d", folder.toString(), "src/test/peers/SunflowPeer.java");
            }
            return new Job(folder, scene, samples);
        }

        /** Without the peer's library this fails, and the peer is then missing. */
        private static void compile(String... command) throws IOException, InterruptedException {
            new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
                    .waitFor();
        }

        String file(String name) {
            return folder.resolve(name).toString();
        }
    }

    static final String JAVA = Path.of(System.getProperty("java.home"), "bin", "java").toString();

    /** Where Debian has it; and our classes, for our parser. */
    private static final String SUNFLOW = String.join(File.pathSeparator, "target/classes", "/usr/share/java/sunflow.jar",
            "/usr/share/java/janino.jar");

    /** Ours, and everything that Debian has packages of. */
    static List<Peer> all() {
        return List.of(
                new Peer("ours", "", job -> with(List.of(JAVA, "-jar", Path.of("target", "raytracer.jar").toAbsolutePath()
                        .toString(), job.file("race.scene"), "--quiet", "-o", job.file("ours.png")),
                        job.samples > 1, "--samples", "" + job.samples)),
                textbook("textbook", "double", 1e-9),
                embree("ray"), embree("packet"),
                new Peer("tachyon", "tachyon", job -> with(List.of("tachyon", job.file("race.dat"), "-o",
                        job.file("tachyon.png"), "-format", "PNG", "-numthreads", "" + threads()), job.samples > 1,
                        "-aasamples", "" + (job.samples * job.samples - 1))),
                new Peer("povray", "povray", job -> with(List.of("povray", "+I" + job.file("race.pov"), "+O"
                        + job.file("povray.png"), "+W" + job.scene.width(), "+H" + job.scene.height(), "-D",
                        "+WT" + threads()), true, job.samples > 1 ? new String[] {"+A0.0", "+AM1", "+R" + job.samples, "-J"}
                                : new String[] {"-A"})),
                new Peer("sunflow", "javac", job -> List.of(JAVA, "-Djava.awt.headless=true", "-cp",
                        job.folder + File.pathSeparator + SUNFLOW, "SunflowPeer", job.file("race.scene"),
                        job.file("sunflow.png"), "" + threads(), "" + job.samples)));
    }

    /** The tracer of textbooks, in Java and on all cores. */
    static Peer textbook(String name, String precision, double epsilon) {
        return new Peer(name, "", job -> List.of(JAVA, "-cp", System.getProperty("java.class.path"),
                TextbookProcess.class.getName(), job.file("race.scene"), job.file("textbook.png"), precision, "" + epsilon,
                "" + job.samples));
    }

    /** @param how one ray at a time or in packets */
    static Peer embree(String how) {
        return new Peer("embree, by " + how, "g++", job -> List.of(job.file("embree"), job.file("race.scene"),
                job.file("embree.ppm"), "" + job.samples, how));
    }

    private static List<String> with(List<String> command, boolean more, String... arguments) {
        List<String> all = new ArrayList<>(command);
        if (more) {
            all.addAll(Arrays.asList(arguments));
        }
        return all;
    }

    private static int threads() {
        return Runtime.getRuntime().availableProcessors();
    }

    static boolean isThere(String program) {
        return program.isEmpty() || Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
                .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
    }

    /** Whether this machine has what it takes. */
    boolean isThere(Job job) {
        return isThere(needs) && (!name.startsWith("embree") || Files.exists(Path.of(job.file("embree"))))
                && (!name.equals("sunflow") || Files.exists(Path.of(job.file("SunflowPeer.class"))));
    }

    /** Renders; returns the milliseconds of the whole process. */
    double run(Job job) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(commands.of(job)).redirectErrorStream(true);
        long start = System.nanoTime();
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes());
        if (process.waitFor() != 0) {
            throw new IOException(name + " failed: " + said);
        }
        return (System.nanoTime() - start) / 1e6;
    }
}
