package raytracer.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Collects what there is to say about a file, with its place and the text there. */
final class Diagnostics {

    /** As many errors as a person wants to read at once. */
    static final int MOST_ERRORS = 20;

    /** In characters: what fits beside a terminal's margin. */
    private static final int LONGEST_EXCERPT = 100;

    private static final int LONGEST_QUOTE = 40;

    private final String file;
    private final LineReader reader;
    private final List<Diagnostic> errors = new ArrayList<>();
    private final List<Diagnostic> warnings = new ArrayList<>();
    private long errorCount;

    Diagnostics(String file, LineReader reader) {
        this.file = file;
        this.reader = reader;
    }

    /**
     * An error on the current line.
     *
     * @param from where it starts in the reader's buffer
     * @param to   behind its end there
     */
    void error(int from, int to, String message) {
        if (++errorCount <= MOST_ERRORS) {
            int column = 1 + characters(reader.start(), from);
            errors.add(new Diagnostic(file, reader.number(), column, message,
                    excerpt(text(reader.start(), reader.end()), column - 1, characters(from, to))));
        }
    }

    /** An error that shows only at the end of the file: what is missing from it. */
    void errorAtEnd(String message) {
        if (++errorCount <= MOST_ERRORS) {
            int column = reader.number() == 0 ? 1 : 1 + characters(reader.start(), reader.end());
            errors.add(new Diagnostic(file, Math.max(1, reader.number()), column, message, ""));
        }
    }

    /** A warning about a line; 0 for the file as a whole. */
    void warning(long line, String message) {
        warnings.add(new Diagnostic(file, line, 1, "warning: " + message, ""));
    }

    boolean clean() {
        return errorCount == 0;
    }

    List<Diagnostic> warnings() {
        return warnings;
    }

    SceneException exception() {
        return new SceneException(errors, errorCount - errors.size());
    }

    /** Part of the buffer in quotes, fit to be shown: control characters replaced, and cut if it is long. */
    String quote(int from, int to) {
        String text = text(from, to);
        boolean whole = text.codePointCount(0, text.length()) <= LONGEST_QUOTE;
        return "'" + (whole ? text : text.substring(0, text.offsetByCodePoints(0, LONGEST_QUOTE)) + "...") + "'";
    }

    private String text(int from, int to) {
        String text = new String(reader.buffer(), from, to - from, StandardCharsets.UTF_8);
        return text.replaceAll("[\\p{Cntrl}\\p{Cf}&&[^\t]]", "\uFFFD");
    }

    /** How many characters a part of the buffer holds: bytes that do not continue a UTF-8 sequence. */
    private int characters(int from, int to) {
        int count = 0;
        for (int i = from; i < to; i++) {
            if ((reader.buffer()[i] & 0xC0) != 0x80) {
                count++;
            }
        }
        return count;
    }

    private static String excerpt(String line, int start, int length) {
        if (line.isEmpty()) {
            return "";
        }
        int[] characters = line.codePoints().toArray();
        int cut = Math.max(0, Math.min(start - LONGEST_EXCERPT / 2, characters.length - LONGEST_EXCERPT));
        int end = Math.min(characters.length, cut + LONGEST_EXCERPT);
        int mark = Math.min(start, end);
        StringBuilder blanks = new StringBuilder();
        for (int i = cut; i < mark; i++) {
            blanks.append(characters[i] == '\t' ? '\t' : ' ');
        }
        int tildes = Math.max(0, Math.min(length, end - mark) - 1);
        return new String(characters, cut, end - cut) + "\n" + blanks + "^" + "~".repeat(tildes);
    }
}
