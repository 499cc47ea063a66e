package raytracer.parser;

import java.util.List;
import java.util.Locale;

/** The commands of the format, and what stands behind their keywords: numbers, or for one the rest of the line. */
enum Command {

    SIZE("w h"),
    CAMERA("ex ey ez ax ay az ux uy uz fov"),
    OUTPUT("name"),
    MAXDEPTH("n"),
    SHADOW("true|false"),
    AMBIENT("r g b"),
    DIFFUSE("r g b"),
    SPECULAR("r g b"),
    SHININESS("s"),
    DIRECTIONAL("x y z r g b"),
    POINT("x y z r g b"),
    MAXVERTS("n"),
    VERTEX("x y z"),
    TRI("i j k"),
    SPHERE("x y z r"),
    PLANE("x y z nx ny nz");

    private static final List<Command> ALL = List.of(values());

    private final String keyword = name().toLowerCase(Locale.ROOT);
    private final String[] operands;

    Command(String operands) {
        this.operands = operands.split(" ");
    }

    String keyword() {
        return keyword;
    }

    /** What messages call the operands. */
    String[] operands() {
        return operands;
    }

    /** The command of this keyword, or null. */
    static Command of(String word) {
        for (int i = 0; i < ALL.size(); i++) {
            if (ALL.get(i).keyword.equals(word)) {
                return ALL.get(i);
            }
        }
        return null;
    }

    /** What to do about a word that is no command, but one of other formats, or close to one; else nothing. */
    static String advice(String word) {
        return switch (word.toLowerCase(Locale.ROOT)) {
            case "shadows" -> "; did you mean 'shadow'?";
            case "emission" -> "; add its colour to 'ambient'";
            case "attenuation" -> "; lights do not weaken with distance: take the line out";
            case "checker", "texture" -> "; a shape has one colour: 'diffuse r g b'";
            case "colour", "color" -> "; 'diffuse r g b' holds for the shapes after it";
            case "light" -> "; 'point x y z r g b' or 'directional x y z r g b'";
            case "lens" -> "; the camera is a pinhole, and all is sharp: take the line out";
            case "index", "refraction", "ior" -> "; nothing can be seen through: take the line out";
            case "sampling", "samples", "antialiasing" -> "; the option --samples N smooths edges: take the line out";
            case "reflection", "reflectivity", "reflect" ->
                "; mirrors have the colour of 'specular', and show as deep as 'maxdepth'";
            case "translate", "rotate", "scale", "pushtransform", "poptransform", "transform" ->
                "; the format has no transformations: write coordinates out";
            case "maxvertnorms", "vertexnormal", "trinormal", "vn", "vt" ->
                "; triangles are flat, of one colour: use 'maxverts', 'vertex' and 'tri'";
            case "v", "f" -> "; this is an OBJ file's: here it is 'maxverts n', 'vertex x y z', and 'tri i j k' from 0 on"
                    + " (README has a recipe)";
            case "triangle" -> "; 'tri i j k' is one, of three vertices declared above";
            case "background" -> "; what meets nothing is black: take the line out";
            default -> {
                Command near = near(word);
                yield near == null ? "" : "; did you mean '" + near.keyword + "'?";
            }
        };
    }

    /** The command that a word may be meant to be; null if it is close to none. */
    static Command near(String word) {
        String near = Spelling.nearest(word.toLowerCase(Locale.ROOT), ALL.stream().map(Command::keyword).toList());
        return near == null ? null : of(near);
    }
}
