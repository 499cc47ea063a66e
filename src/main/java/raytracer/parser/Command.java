package raytracer.parser;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

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

    private static final Map<String, Command> BY_KEYWORD = new HashMap<>();

    static {
        for (Command command : values()) {
            BY_KEYWORD.put(command.keyword, command);
        }
    }

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
        return BY_KEYWORD.get(word);
    }

    /** {@code ; did you mean 'sphere'?} for a word that is close to a keyword, else nothing. */
    static String suggestion(String word) {
        String best = null;
        int min = MAX_EDITS + 1;
        for (Command command : values()) {
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
