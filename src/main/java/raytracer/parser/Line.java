package raytracer.parser;

import java.nio.charset.StandardCharsets;

/** The words of one line, read from left to right; a comment ends the line. */
final class Line {

    /** 10^0 to 10^22: the powers of ten that a double holds exactly. */
    private static final double[] POWERS_OF_TEN = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    /** Every number of so many digits fits in a long. */
    private static final int DIGITS_OF_A_LONG = 18;

    private static final int HUGE_EXPONENT = 100_000;

    private final LineReader reader;
    private byte[] bytes;
    private int from;
    private int to;

    Line(LineReader reader) {
        this.reader = reader;
    }

    /** Goes to the first word of the reader's line; false if there is none. */
    boolean firstWord() {
        bytes = reader.buffer();
        to = reader.start();
        return nextWord();
    }

    /** Goes to the next word; false at the end of the line and at a comment. */
    boolean nextWord() {
        if (!nextWordStart()) {
            return false;
        }
        int i = from;
        while (!endsWord(bytes[i])) {
            i++;
        }
        to = i;
        return true;
    }

    private boolean nextWordStart() {
        int i = to;
        while (bytes[i] == ' ' || bytes[i] == '\t') {
            i++;
        }
        from = i;
        to = i;
        return bytes[i] != '\n' && bytes[i] != '#';
    }

    private static boolean endsWord(byte b) {
        return b == ' ' || b == '\t' || b == '\n';
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

    /** Where the current word starts in the buffer. */
    int from() {
        return from;
    }

    /** Behind the current word. */
    int to() {
        return to;
    }

    String word() {
        return new String(bytes, from, to - from, StandardCharsets.UTF_8);
    }

    /**
     * Goes to the next word and reads it as a decimal number, correctly rounded. Digits that fit in 53 bits and a power
     * of ten up to 22 are both exact, so one multiplication or division rounds once (Clinger, How to Read Floating
     * Point Numbers Accurately, 1990); the library reads all others.
     *
     * @return the number; an infinity if it is too large for a double; NaN if there is no word or it is no number
     */
    double nextNumber() {
        if (!nextWordStart()) {
            return Double.NaN;
        }
        byte[] b = bytes;
        int i = from;
        boolean negative = b[i] == '-';
        if (negative || b[i] == '+') {
            i++;
        }
        long digits = 0;
        int start = i;
        for (int d; (d = b[i] - '0') >= 0 && d <= 9; i++) {
            digits = 10 * digits + d;
        }
        int count = i - start;
        int exponent = 0;
        if (b[i] == '.') {
            int point = ++i;
            for (int d; (d = b[i] - '0') >= 0 && d <= 9; i++) {
                digits = 10 * digits + d;
            }
            exponent = point - i;
            count -= exponent;
        }
        boolean valid = count > 0;
        if ((b[i] == 'e' || b[i] == 'E') && valid) {
            i++;
            boolean negativeExponent = b[i] == '-';
            if (negativeExponent || b[i] == '+') {
                i++;
            }
            int power = 0;
            int exponentStart = i;
            for (int d; (d = b[i] - '0') >= 0 && d <= 9; i++) {
                power = Math.min(10 * power + d, HUGE_EXPONENT);
            }
            valid = i > exponentStart;
            exponent += negativeExponent ? -power : power;
        }
        if (!valid || !endsWord(b[i])) {
            nextWord();
            return Double.NaN;
        }
        to = i;
        if (count > DIGITS_OF_A_LONG || digits > 1L << 53 || exponent < -22 || exponent > 22) {
            return Double.parseDouble(new String(b, from, to - from, StandardCharsets.ISO_8859_1));
        }
        double value = exponent < 0 ? digits / POWERS_OF_TEN[-exponent] : digits * POWERS_OF_TEN[exponent];
        return negative ? -value : value;
    }
}
