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

    // While a number is read: the next byte, and the digits so far.
    private int at;
    private long mantissa;

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
        at = from;
        boolean negative = sign();
        mantissa = 0;
        int count = digits();
        int exponent = 0;
        if (bytes[at] == '.') {
            at++;
            exponent = -digits();
            count -= exponent;
        }
        boolean valid = count > 0;
        if (valid && (bytes[at] == 'e' || bytes[at] == 'E')) {
            at++;
            int start = at;
            exponent += power();
            valid = at > start && bytes[at - 1] >= '0';
        }
        if (!valid || !endsWord(bytes[at])) {
            nextWord();
            return Double.NaN;
        }
        to = at;
        if (count > DIGITS_OF_A_LONG || mantissa > 1L << 53 || Math.abs(exponent) >= POWERS_OF_TEN.length) {
            return Double.parseDouble(word());
        }
        double value = exponent < 0 ? mantissa / POWERS_OF_TEN[-exponent] : mantissa * POWERS_OF_TEN[exponent];
        return negative ? -value : value;
    }

    /** Reads a sign, if there is one; returns whether it is negative. */
    private boolean sign() {
        boolean negative = bytes[at] == '-';
        if (negative || bytes[at] == '+') {
            at++;
        }
        return negative;
    }

    /** Appends digits to the mantissa; returns how many. */
    private int digits() {
        byte[] b = bytes;
        int i = at;
        for (int d; (d = b[i] - '0') >= 0 && d <= 9; i++) {
            mantissa = 10 * mantissa + d;
        }
        int count = i - at;
        at = i;
        return count;
    }

    /** Reads the exponent behind an e. */
    private int power() {
        boolean negative = sign();
        int power = 0;
        for (int d; (d = bytes[at] - '0') >= 0 && d <= 9; at++) {
            power = Math.min(10 * power + d, HUGE_EXPONENT);
        }
        return negative ? -power : power;
    }
}
