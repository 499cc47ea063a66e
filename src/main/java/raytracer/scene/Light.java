package raytracer.scene;

/** What shines on the whole scene. */
public sealed interface Light {

    Colour colour();

    /**
     * A light at infinity.
     *
     * @param towards points towards the light; any length but 0
     */
    record Directional(Vector towards, Colour colour) implements Light { }

    /** A light at a point; its strength does not fall off with distance. */
    record Point(Vector position, Colour colour) implements Light { }
}
