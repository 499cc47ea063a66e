package raytracer.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import raytracer.files.Destination;
import raytracer.files.Reason;
import raytracer.image.PictureFile;
import raytracer.parser.ParsedScene;
import raytracer.parser.SceneException;
import raytracer.parser.SceneParser;

/** A scene as the command line names it: a file, or standard input. */
record Input(String file) {

    /** What messages call it. */
    String name() {
        return isStandard() ? "<stdin>" : file;
    }

    boolean isStandard() {
        return file.equals(Destination.STANDARD);
    }

    Path path() throws IOException {
        return Reason.path(file);
    }

    /** Whether it is no scene but a picture. */
    boolean isPicture() throws IOException {
        if (isStandard() || !Files.isRegularFile(path())) {
            return false;
        }
        try (InputStream in = Files.newInputStream(path()); PictureFile picture = PictureFile.open(in)) {
            return picture != null;
        }
    }

    ParsedScene parse() throws SceneException, IOException {
        try (InputStream in = open()) {
            return SceneParser.parse(name(), in);
        } catch (IOException e) {
            throw unreadable(e);
        }
    }

    /** All of the text, which is parsed from memory then. */
    byte[] read() throws IOException {
        try (InputStream in = open()) {
            return in.readAllBytes();
        } catch (IOException e) {
            throw unreadable(e);
        }
    }

    private InputStream open() throws IOException {
        if (Files.isDirectory(path())) {
            throw new IOException("expected a scene file, found a directory");
        }
        if (isStandard() && isStandardInputClosed()) {
            throw new IOException("standard input is closed");
        }
        return isStandard() ? System.in : Files.newInputStream(path());
    }

    /** If so, the first file that Java opens for itself takes its number, and would be read for it. */
    private static boolean isStandardInputClosed() {
        try {
            return Path.of("/proc/self/fd/0").toRealPath().startsWith(Path.of(System.getProperty("java.home")).toRealPath());
        } catch (IOException e) {
            return false;
        }
    }

    private IOException unreadable(IOException e) {
        return new IOException("cannot read the scene: " + Reason.of(e) + Reason.ofEncoding(file), e);
    }
}
