package raytracer.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** --watch. */
class WatchTest extends CommandLine {

    private static final String TEXT = "size 8 8\ncamera 0 0 5 0 0 0 0 1 0 45\nambient .%d 0 0\nsphere 0 0 0 9\n";

    private final AtomicInteger status = new AtomicInteger(-1);
    private Thread watching;

    WatchTest() {
        super(String.format(TEXT, 1));
    }

    @BeforeEach
    void watch() {
        watching = new Thread(() -> status.set(run("--watch", scene, "-o", picture, "--quiet")));
        watching.start();
    }

    @AfterEach
    void stop() throws InterruptedException {
        watching.interrupt();
        watching.join();
    }

    private int red() {
        try {
            return ImageIO.read(new File(picture)).getRGB(4, 4) >> 16 & 255;
        } catch (IOException | RuntimeException e) {
            return -1;
        }
    }

    private void await(int tenths) {
        int wanted = (int) (25.5 * tenths + .5);
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            while (red() != wanted) {
                Thread.sleep(2);
            }
        }, () -> "expected " + wanted + ", found " + red() + "; " + err());
    }

    private void saveInPlace(int tenths) throws IOException {
        Files.writeString(Path.of(scene), String.format(TEXT, tenths));
    }

    private void saveByRenaming(int tenths) throws IOException {
        Path other = folder.resolve("a.scene~");
        Files.writeString(other, String.format(TEXT, tenths));
        Files.move(other, Path.of(scene), StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }

    @Test
    @DisplayName("renders again when a scene is written in place or replaced, and ends when interrupted")
    void rendersAgain() throws Exception {
        await(1);
        saveInPlace(2);
        await(2);
        saveByRenaming(3);
        await(3);
        saveByRenaming(4);
        await(4);
        saveInPlace(5);
        await(5);
        stop();
        assertEquals(0, status.get());
        assertEquals(2, Files.list(folder).count(), "the scene and its picture, nothing else");
    }

    @Test
    void showsAMistakeAndKeepsTheOldPicture() throws Exception {
        await(1);
        Files.writeString(Path.of(scene), "size 8 8\ncamera 0 0 5 0 0 0 0 1 0 45\nball 0 0 0 9\n");
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            while (!err().contains(":3:1: expected a command, found 'ball'")) {
                Thread.sleep(2);
            }
        });
        assertEquals(26, red());
        saveInPlace(7);
        await(7);
    }

    @Test
    void followsAHundredSaves() throws Exception {
        await(1);
        for (int save = 0; save < 100; save++) {
            if (save % 2 == 0) {
                saveInPlace(1 + save % 9);
            } else {
                saveByRenaming(1 + save % 9);
            }
            Thread.sleep(save % 7);
        }
        await(1 + 99 % 9);
    }

    @Test
    void refusesWhatCanNeverSucceed() throws IOException {
        assertEquals(2, run("--watch", "-"));
        assertEquals(2, run("--watch", folder.toString()));
        assertTrue(err().contains("--watch goes with files, found standard input"), err());
        assertTrue(err().contains("--watch goes with files, found the directory " + folder), err());
        assertEquals(2, run("--watch", scene, "-o", scene));
        String one = file("one.scene", String.format(TEXT, 1)), two = file("two.scene", String.format(TEXT, 2));
        assertEquals(2, run("--watch", one, two));
        assertTrue(err().contains("the picture of " + two + " (output.png) would replace the picture of " + one), err());
        assertFalse(err().contains("fault"));
    }

    @Test
    void aSaveThatTakesAWhileIsRenderedWhole() throws Exception {
        await(1);
        Files.writeString(Path.of(scene), "size 8 8\ncamera 0 0 5 0 0 0 0 1 0 45\n");
        Thread.sleep(100);
        Files.writeString(Path.of(scene), "ambient .8 0 0\nsphere 0 0 0 9\n", StandardOpenOption.APPEND);
        await(8);
        assertEquals("", err(), "no black picture in between");
    }

    @Test
    void aPictureStaysWhereItIsWhenTheSceneNamesNoOutputAnyMore() throws Exception {
        Path named = Path.of("target", "watch-test.png"), usual = Path.of("output.png");
        Files.deleteIfExists(named);
        String own = file("own.scene", String.format(TEXT, 1) + "output " + named + "\n");
        Thread other = new Thread(() -> run("--watch", own, "--quiet"));
        other.start();
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            while (!Files.exists(named)) {
                Thread.sleep(2);
            }
            Files.delete(named);
            Files.writeString(Path.of(own), String.format(TEXT, 2));
            while (!Files.exists(named)) {
                Thread.sleep(2);
            }
        });
        other.interrupt();
        other.join();
        assertFalse(Files.exists(usual));
        Files.delete(named);
    }

    @Test
    void aFileThatIsNotThereYetIsMissedOnce() throws Exception {
        Path late = folder.resolve("late.scene"), its = folder.resolve("late.png");
        Thread other = new Thread(() -> run("--watch", late.toString(), "-o", its.toString(), "--quiet"));
        other.start();
        Thread.sleep(200);
        Files.writeString(late, String.format(TEXT, 3));
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            while (!Files.exists(its)) {
                Thread.sleep(2);
            }
        });
        other.interrupt();
        other.join();
        assertEquals(1, err().lines().filter(line -> line.contains("late.scene: there is no such file")).count(), err());
    }
}
