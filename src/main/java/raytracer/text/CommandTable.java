package raytracer.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The commands of the format by keyword, found without making a string of the word. */
final class CommandTable<R> {

    /** @param text whether the operand is the rest of the line instead of numbers */
    record Command<R>(String keyword, byte[] ascii, String[] operands, boolean text, R rule) { }

    /** A power of two, and several times the number of commands, so that hardly two meet in one place. */
    private static final int PLACES = 128;

    /** Typing errors that a suggestion forgives. */
    private static final int MOST_EDITS = 2;

    private final List<Command<R>> commands = new ArrayList<>();
    private final List<List<Command<R>>> places = new ArrayList<>();

    CommandTable() {
        for (int i = 0; i < PLACES; i++) {
            places.add(List.of());
        }
    }

    void add(String keyword, String operands, R rule) {
        add(new Command<>(keyword, keyword.getBytes(StandardCharsets.US_ASCII), operands.split(" "), false, rule));
    }

    void addText(String keyword, String operand, R rule) {
        add(new Command<>(keyword, keyword.getBytes(StandardCharsets.US_ASCII), new String[] {operand}, true, rule));
    }

    private void add(Command<R> command) {
        commands.add(command);
        int place = command.keyword.hashCode() & PLACES - 1;
        List<Command<R>> there = new ArrayList<>(places.get(place));
        there.add(command);
        places.set(place, there);
    }

    /** The command that the line's current word names, or null. */
    Command<R> find(Line line) {
        List<Command<R>> there = places.get(line.wordHash() & PLACES - 1);
        for (int i = 0; i < there.size(); i++) {
            if (line.wordIs(there.get(i).ascii)) {
                return there.get(i);
            }
        }
        return null;
    }

    /** {@code ; did you mean 'sphere'?} for a word that is close to a keyword, else nothing. */
    String suggestion(String word) {
        String best = null;
        int least = MOST_EDITS + 1;
        for (Command<R> command : commands) {
            int edits = edits(word.toLowerCase(Locale.ROOT), command.keyword);
            if (edits < least && edits < command.keyword.length() - 1) {
                least = edits;
                best = command.keyword;
            }
        }
        return best == null ? "" : "; did you mean '" + best + "'?";
    }

    /** The Levenshtein distance, or more than {@link #MOST_EDITS} if the lengths alone say so. */
    private static int edits(String a, String b) {
        if (Math.abs(a.length() - b.length()) > MOST_EDITS) {
            return MOST_EDITS + 1;
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
