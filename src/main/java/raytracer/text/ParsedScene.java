package raytracer.text;

import java.util.List;
import raytracer.scene.Scene;

/** A valid scene, and what its author may not have meant. */
public record ParsedScene(Scene scene, List<Diagnostic> warnings) {

    public ParsedScene {
        warnings = List.copyOf(warnings);
    }
}
