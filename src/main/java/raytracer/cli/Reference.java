package raytracer.cli;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import raytracer.image.Comparison;
import raytracer.image.PngFile;
import raytracer.render.Region;

/** The picture that a rendering is compared with. */
record Reference(String file, BufferedImage picture, int tolerance) {

    static Reference read(String file, int tolerance, Region region) throws IOException, UsageException {
        BufferedImage picture;
        try {
            if (!Files.exists(Reason.path(file))) {
                throw new NoSuchFileException(file);
            }
            picture = ImageIO.read(Reason.path(file).toFile());
        } catch (IOException e) {
            throw new IOException("cannot read the reference " + file + ": " + Reason.of(e), e);
        }
        if (picture == null) {
            throw new IOException("cannot read the reference " + file
                    + ": it is no PNG, nor another kind that Java reads");
        }
        if (picture.getWidth() != region.width() || picture.getHeight() != region.height()) {
            throw new UsageException("expected the reference " + file + " to be " + region.width() + "x"
                    + region.height() + " as the picture, found " + picture.getWidth() + "x" + picture.getHeight());
        }
        return new Reference(file, picture, tolerance);
    }

    /** Says how a picture differs, and shows where in a picture of its own; returns the exit status. */
    int compare(BufferedImage actual, Destination destination, PrintStream words) throws IOException {
        Comparison c = Comparison.of(actual, picture, tolerance);
        if (c.pixels() == 0) {
            words.println("equals " + file + " in every pixel");
            return Main.DONE;
        }
        Path difference = destination.ofDifferences();
        words.printf(Locale.ROOT, "%d of %d pixels differ from %s, by at most %d of 255 at (%d, %d); RMSE %.4f of 255;"
                        + " columns %d to %d, rows %d to %d; see %s%n",
                c.pixels(), (long) actual.getWidth() * actual.getHeight(), file, c.greatest(), c.x(), c.y(), c.rmse(),
                c.left(), c.right(), c.top(), c.bottom(), difference);
        try {
            PngFile.write(c.difference(), difference);
        } catch (IOException e) {
            throw new IOException("cannot write " + difference + ": " + Reason.of(e), e);
        }
        if (c.beyond() == 0) {
            words.println("none by more than the tolerance of " + tolerance);
        }
        return c.beyond() == 0 ? Main.DONE : Main.DIFFERS;
    }
}
