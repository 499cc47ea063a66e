package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A folder with one scene in it, and the program to be run there. */
abstract class CommandLine {

    @TempDir
    Path folder;

    final ByteArrayOutputStream out = new ByteArrayOutputStream();
    final ByteArrayOutputStream err = new ByteArrayOutputStream();

    /** The scene's file, and where its picture may go. */
    String scene;
    String picture;

    private final String text;

    CommandLine(String text) {
        this.text = text;
    }

    @BeforeEach
    void writeScene() throws IOException {
        scene = file("a.scene", text);
        picture = folder.resolve("a.png").toString();
    }

    final String file(String name, String content) throws IOException {
        return Files.writeString(folder.resolve(name), content).toString();
    }

    final int run(String... args) {
        return Main.run(args, new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8));
    }

    /** Runs the scene with arguments that make no sense. */
    final void assertRefused(String args, String message) {
        assertEquals(2, run((scene + " " + args).split(" ")));
        assertTrue(err().contains(message), err());
    }

    final String out() {
        return out.toString(StandardCharsets.UTF_8);
    }

    final String err() {
        return err.toString(StandardCharsets.UTF_8);
    }
}
