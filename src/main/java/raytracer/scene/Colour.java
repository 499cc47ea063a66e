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
}
