package raytracer.parser;

import java.util.List;
import java.util.Locale;

/** The commands of the format, and what stands behind their keywords: numbers, or for one the rest of the line. */
enum Command {

    SIZE("w h"),
    CAMERA("ex ey ez ax ay az ux uy uz fov"),
    OUTPUT("name"),
    MAXDEPTH("n"),
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

    /** Typing errors that a suggestion forgives. */
    private static final int MAX_EDITS = 2;

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

    /** What to do about a word that is no command, but one of other scene formats, or close to one; else nothing. */
    static String advice(String word) {
        return switch (word) {
            case "shadow", "shadows" -> "; shadows are always on: take the line out";
            case "emission" -> "; add its colour to 'ambient'";
            case "attenuation" -> "; lights do not weaken with distance: take the line out";
            case "checker", "texture" -> "; a shape has one colour: 'diffuse r g b'";
            case "sampling", "samples", "antialiasing" -> "; the option --samples N smooths edges: take the line out";
            case "reflection", "reflectivity", "reflect" ->
                "; mirrors have the colour of 'specular', and show as deep as 'maxdepth'";
            case "translate", "rotate", "scale", "pushTransform", "popTransform", "transform" ->
                "; the format has no transformations: write coordinates out";
            case "maxvertnorms", "vertexnormal", "trinormal" ->
                "; triangles are flat: use 'maxverts', 'vertex' and 'tri'";
            case "background" -> "; what meets nothing is black: take the line out";
            default -> suggestion(word);
        };
    }

    /** {@code ; did you mean 'sphere'?} for a word that is close to a keyword, else nothing. */
    private static String suggestion(String word) {
        String best = null;
        int min = MAX_EDITS + 1;
        for (Command command : ALL) {
            int edits = edits(word.toLowerCase(Locale.ROOT), command.keyword);
            if (edits < min && edits < command.keyword.length() - 1) {
                min = edits;
                best = command.keyword;
            }
        }
        return best == null ? "" : "; did you mean '" + best + "'?";
    }

    /** The Levenshtein distance, or more than {@link #MAX_EDITS} if the lengths alone say so. */
    private static int edits(String a, String b) {
        if (Math.abs(a.length() - b.length()) > MAX_EDITS) {
            return MAX_EDITS + 1;
        }
        int[] above = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            above[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] row = new int[b.length() + 1];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = above[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                row[j] = Math.min(replaced, 1 + Math.min(above[j], row[j - 1]));
            }
            above = row;
        }
        return above[b.length()];
    }
}
