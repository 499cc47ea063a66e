package raytracer.parser;

import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/** The words of one line, read from left to right; a comment ends the line. */
final class Line {

    /** Each is exact, as is every one up to 10^22. */
    private static final double[] POWERS_OF_TEN = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};

    /** So many characters hold no more digits than a long does. */
    private static final int MAX_LENGTH = 18;

    private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d++\\.?+\\d*+|\\.\\d++)([eE][-+]?\\d++)?+");

    private final LineReader reader;
    private byte[] bytes;

    // Where the current word starts in the buffer, and behind it.
    int from;
    int to;

    Line(LineReader reader) {
        this.reader = reader;
    }

    /** Goes to the first word of the reader's line; false if there is none. */
    boolean firstWord() {
        bytes = reader.buffer;
        to = reader.start;
        return nextWord();
    }

    /** Goes to the next word; false at the end of the line and at a comment. */
    boolean nextWord() {
        int i = to;
        while (bytes[i] == ' ' || bytes[i] == '\t') {
            i++;
        }
        from = i;
        if (bytes[i] != '#') {
            while (bytes[i] != ' ' && bytes[i] != '\t' && bytes[i] != '\n') {
                i++;
            }
        }
        to = i;
        return to > from;
    }

    /** Goes to the next word and as far beyond it as the line goes, blanks and comment at the end left out. */
    boolean rest() {
        if (!nextWord()) {
            return false;
        }
        int start = from;
        int end = to;
        while (nextWord()) {
            end = to;
        }
        from = start;
        to = end;
        return true;
    }

    String word() {
        return new String(bytes, from, to - from, StandardCharsets.UTF_8);
    }

    /**
     * Goes to the next word and reads it as a decimal number, correctly rounded. If it has no exponent and its digits fit
     * in 53 bits, they and the power of ten are both exact, so one division rounds once (Clinger, How to Read Floating
     * Point Numbers Accurately, 1990); the library reads all others.
     *
     * @return the number; an infinity if it is too large for a double; NaN if there is no word or it is no number
     */
    double nextNumber() {
        if (!nextWord()) {
            return Double.NaN;
        }
        boolean isNegative = bytes[from] == '-';
        int first = isNegative || bytes[from] == '+' ? from + 1 : from;
        int point = to;
        long mantissa = 0;
        for (int i = first; i < to; i++) {
            int digit = bytes[i] - '0';
            if (digit >= 0 && digit <= 9) {
                mantissa = 10 * mantissa + digit;
            } else if (bytes[i] == '.' && point == to) {
                point = i;
            } else {
                return readByLibrary();
            }
        }
        int decimals = Math.max(0, to - 1 - point), digits = to - first - (point < to ? 1 : 0);
        if (digits == 0 || to - first > MAX_LENGTH || mantissa > 1L << 53) {
            return readByLibrary();
        }
        double value = mantissa / POWERS_OF_TEN[decimals];
        return isNegative ? -value : value;
    }

    private double readByLibrary() {
        String word = word();
        return NUMBER.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
    }
}
