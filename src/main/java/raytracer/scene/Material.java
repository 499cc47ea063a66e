package raytracer.scene;

/**
 * How a surface answers light: Lambert plus Blinn-Phong; {@code specular} is also the colour of its mirror.
 *
 * @param shininess the highlight's exponent: any finite number
 */
public record Material(Colour ambient, Colour diffuse, Colour specular, double shininess) {

    /** What a shape is made of that is declared before any material command. */
    public static final Material DEFAULT = new Material(Colour.BLACK, Colour.BLACK, Colour.BLACK, 1);
}
