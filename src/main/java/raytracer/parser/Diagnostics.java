package raytracer.parser;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** Collects what there is to say about a file, with its place and the text there. */
final class Diagnostics {

    /** As many errors as a person wants to read at once. */
    static final int MAX_ERRORS = 20;

    /** A file with more errors is none of ours. */
    private static final int ENOUGH = 1000;

    /** In characters: what fits beside a terminal's margin. */
    private static final int LONGEST_EXCERPT = 100;

    private static final int LONGEST_QUOTE = 40;

    private final String file;
    private final LineReader reader;
    private final List<Diagnostic> errors = new ArrayList<>();
    private final List<Diagnostic> warnings = new ArrayList<>();
    private long errorCount;

    /** By word that is no command: on how many lines it is. */
    private final Map<String, Long> unknown = new HashMap<>();

    /** By number of an error that is listed: the word that is no command. */
    private final Map<Integer, String> unknownAt = new HashMap<>();

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
        if (++errorCount <= MAX_ERRORS) {
            int column = column(from);
            errors.add(new Diagnostic(file, reader.number, column, message,
                    excerpt(text(reader.start, reader.end), column - 1, characters(from, to))));
        }
    }

    /** In characters, from 1, of a place in the current line. */
    int column(int at) {
        return 1 + characters(reader.start, at);
    }

    /** An error of the file as a whole: its place is the beginning. */
    void errorOfFile(String message) {
        if (++errorCount <= MAX_ERRORS) {
            errors.add(new Diagnostic(file, 1, 1, message, ""));
        }
    }

    /** A word on the current line that is no command; one error, however often it comes. */
    void unknownCommand(String word, int from, int to) {
        if (unknown.merge(word, 1L, Long::sum) == 1) {
            unknownAt.put(errors.size(), word);
            error(from, to, "expected a command, found " + quote(from, to));
        }
    }

    private Diagnostic completed(Diagnostic e, String word) {
        long lines = unknown.get(word);
        return new Diagnostic(e.file(), e.line(), e.column(),
                e.message() + (lines == 1 ? "" : " (on " + lines + " lines)") + Command.advice(word), e.excerpt());
    }

    /** Whether so much is wrong that reading on is no use. */
    boolean isHopeless() {
        return errorCount >= ENOUGH;
    }

    /** A warning about a line. */
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
        for (int i = 0; i < errors.size(); i++) {
            if (unknownAt.containsKey(i)) {
                errors.set(i, completed(errors.get(i), unknownAt.get(i)));
            }
        }
        long unlisted = errorCount - errors.size();
        return new SceneException(errors, errorCount, unlisted == 0 ? "" : unlisted + (unlisted == 1 ? " more error" : " more errors")
                + (isHopeless() ? "; the rest was not read" : ""));
    }

    /**
     * Part of the buffer in quotes, fit to be shown: control characters replaced, and cut if it is long. Characters
     * that may look like others, or like nothing, are numbered behind it.
     */
    String quote(int from, int to) {
        String text = text(from, to);
        boolean whole = text.codePointCount(0, text.length()) <= LONGEST_QUOTE;
        String numbers = decoded(from, to).codePoints().filter(c -> c > 126 && c != 0xFFFD).distinct().limit(3)
                .mapToObj(c -> String.format(Locale.ROOT, "U+%04X", c)).collect(Collectors.joining(", "));
        return "'" + (whole ? text : text.substring(0, text.offsetByCodePoints(0, LONGEST_QUOTE)) + "...") + "'"
                + (numbers.isEmpty() ? "" : " (with " + numbers + ")");
    }

    private String decoded(int from, int to) {
        return new String(reader.buffer, from, to - from, StandardCharsets.UTF_8);
    }

    private String text(int from, int to) {
        return decoded(from, to).replaceAll("[\\p{Cntrl}\\p{Cf}&&[^\t]]", "\uFFFD");
    }

    /** How many characters a part of the buffer holds: bytes that do not continue a UTF-8 sequence. */
    private int characters(int from, int to) {
        int count = 0;
        for (int i = from; i < to; i++) {
            if ((reader.buffer[i] & 0xC0) != 0x80) {
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

    /** Whether the file, of which the current line is the first, is of a kind that is often taken for a scene. */
    boolean isNoText() {
        byte[] b = reader.buffer;
        int at = reader.start, first = b[at] & 0xFF, second = b[at + 1] & 0xFF;
        if (reader.end - at < 2) {
            return false;
        }
        if (first == 0x89 && second == 'P') {
            errorOfFile("expected a scene, found a PNG picture; -o FILE names the output");
        } else if (first == 0xFF && second == 0xFE || first == 0xFE && second == 0xFF || first == 0 || second == 0) {
            errorOfFile("expected UTF-8 text, found UTF-16; save the file as UTF-8");
        }
        return !clean();
    }
}
