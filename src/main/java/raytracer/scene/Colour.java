package raytracer.scene;

/**
 * A linear colour or reflectance.
 *
 * @param red   finite, at least 0, as are the others; 1 is full intensity on screen
 */
public record Colour(double red, double green, double blue) {

    public static final Colour BLACK = new Colour(0, 0, 0);

    public boolean isBlack() {
        return red == 0 && green == 0 && blue == 0;
    }

    // Written out for the reason that Material has.

    @Override
    public boolean equals(Object other) {
        return other instanceof Colour c && Double.compare(red, c.red) == 0 && Double.compare(green, c.green) == 0
                && Double.compare(blue, c.blue) == 0;
    }

    @Override
    public int hashCode() {
        return (Double.hashCode(red) * 31 + Double.hashCode(green)) * 31 + Double.hashCode(blue);
    }
}
