package raytracer.files;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import raytracer.image.Comparison;
import raytracer.image.PictureFile;
import raytracer.image.PngFile;

/**
 * A picture that another is compared with.
 *
 * @param file       where it is
 * @param picture    null if it has another size
 * @param difference where a picture of the differences goes; null if nowhere
 */
public record Reference(Path file, int width, int height, BufferedImage picture, int tolerance, Path difference) {

    /**
     * What came of it.
     *
     * @param isPassed   whether nothing differs by more than the tolerance
     * @param comparison null if the sizes differ
     */
    public record Verdict(String words, boolean isPassed, Comparison comparison) { }

    /**
     * Where the reference of a scene or picture is: what --compare names, or in that folder NAME.png.
     *
     * @param named what --compare names
     */
    public static Path of(String named, Path subject) throws IOException {
        Path place = Reason.path(named);
        if (!Files.isDirectory(place)) {
            return place;
        }
        return place.resolve(Destination.baseName(subject) + ".png");
    }

    /** @param width of the picture that is compared; pixels of another size are not read */
    public static Reference read(Path file, int width, int height, int tolerance, Path difference) throws IOException {
        try (InputStream in = Files.newInputStream(file); PictureFile picture = PictureFile.open(in)) {
            if (picture == null) {
                throw new IOException("it is no PNG, nor another kind that Java reads");
            }
            int w = picture.width(), h = picture.height();
            boolean sameSize = w == width && h == height;
            return new Reference(file, w, h, sameSize ? picture.read() : null, tolerance, difference);
        } catch (IOException e) {
            throw new IOException("cannot read the picture " + file + ": " + Reason.of(e), e);
        }
    }

    /** Says how a picture differs, and shows where in a picture of its own. */
    public Verdict compare(BufferedImage actual) throws IOException {
        if (picture == null) {
            return new Verdict("differs from " + file + " in size: " + actual.getWidth() + "x" + actual.getHeight()
                    + ", and that is " + width + "x" + height, false, null);
        }
        Comparison c = Comparison.of(actual, picture, tolerance);
        if (c.pixels() == 0) {
            return new Verdict("equals " + file + " in every pixel", true, c);
        }
        String words = String.format(Locale.ROOT, "%d of %d pixels differ from %s, by at most %d of 255 at (%d, %d);"
                        + " RMSE %.4f of 255; columns %d to %d, rows %d to %d; ",
                c.pixels(), (long) width * height, file, c.max(), c.x(), c.y(), c.rmse(), c.left(), c.right(),
                c.top(), c.bottom());
        if (tolerance > 0) {
            words += (c.beyond() == 0 ? "none" : c.beyond()) + " by more than the tolerance of " + tolerance + "; ";
        }
        if (c.beyond() > 0 && difference != null) {
            OutputFile.write(difference, out -> PngFile.write(c.difference(), out));
            words += "see " + difference + "; ";
        }
        return new Verdict(words.substring(0, words.length() - 2), c.beyond() == 0, c);
    }
}
