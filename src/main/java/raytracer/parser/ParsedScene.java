package raytracer.parser;

import java.util.List;
import raytracer.scene.Scene;

/**
 * A valid scene, and what its author may not have meant.
 *
 * @param outputPlace where the scene names its output, {@code :line:column}; empty if it does not
 */
public record ParsedScene(Scene scene, List<Diagnostic> warnings, String outputPlace, Colours colours) {

    /**
     * What there is to say of colours if the picture is black, or nearly white.
     *
     * @param firstColourless the line of the first shape that is declared before any ambient or diffuse colour; 0 if none
     *                        is
     * @param lastColourless  the line of the last
     * @param brightest       the greatest component of any colour
     */
    public record Colours(long firstColourless, long lastColourless, double brightest, long brightestLine) { }

    public ParsedScene {
        warnings = List.copyOf(warnings);
    }
}
