package raytracer.parser;

/** What to do about words of other scene formats, which people try here. */
final class Hints {

    private Hints() { }

    /** What a word would mean here, as a sentence that follows a semicolon; null if that is not known. */
    static String of(String word) {
        return switch (word) {
            case "shadow", "shadows" -> "shadows are always on: take the line out";
            case "emission" -> "add its colour to 'ambient'";
            case "attenuation" -> "lights do not weaken with distance: take the line out";
            case "checker", "texture" -> "a shape has one colour: 'diffuse r g b'";
            case "sampling", "samples", "antialiasing" -> "the option --samples N smooths edges: take the line out";
            case "reflection", "reflectivity", "reflect" ->
                "mirrors have the colour of 'specular', and show as deep as 'maxdepth'";
            case "translate", "rotate", "scale", "pushTransform", "popTransform", "transform" ->
                "the format has no transformations: write coordinates out";
            case "maxvertnorms", "vertexnormal", "trinormal" ->
                "triangles are flat: use 'maxverts', 'vertex' and 'tri'";
            case "background" -> "what meets nothing is black: take the line out";
            default -> null;
        };
    }
}
