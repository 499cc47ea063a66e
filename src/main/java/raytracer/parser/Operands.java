package raytracer.parser;

import raytracer.scene.Colour;
import raytracer.scene.Vector;

/**
 * The numbers behind a command's keyword. A rule asks for them by position, as the kind of thing they must be; what is
 * out of range is rejected with its place.
 */
final class Operands {

    /** Says that a command was rejected; the error has been reported. */
    static final class Rejected extends Exception {
        private static final long serialVersionUID = 1;

        private Rejected() {
            super(null, null, false, false);
        }
    }

    private static final Rejected REJECTED = new Rejected();

    private static final int MAX = 10;

    /**
     * Squares and products of two lengths must neither overflow nor lose their last bits, so coordinates are no greater
     * than this, and what has a size is no smaller than one part in so many.
     */
    private static final double MAX_LENGTH = 1e150;
    private static final double MIN_LENGTH = 1 / MAX_LENGTH;

    private final Line line;
    private final Diagnostics diagnostics;
    private final double[] values = new double[MAX];
    private final int[] from = new int[MAX];
    private final int[] to = new int[MAX];
    private int keywordFrom;
    private int keywordTo;
    private String keyword;
    private String[] names;

    Operands(Line line, Diagnostics diagnostics) {
        this.line = line;
        this.diagnostics = diagnostics;
    }

    /** Reads the operands of the command whose keyword is the line's current word. */
    void read(Command command) throws Rejected {
        readKeyword(command);
        for (int i = 0; i < names.length; i++) {
            double value = line.nextNumber();
            from[i] = line.from;
            to[i] = line.to;
            if (!Double.isFinite(value)) {
                throw line.from == line.to ? wrongCount(i) : notANumber(i, value);
            }
            values[i] = value;
        }
        if (line.nextWord()) {
            throw wrongCount(names.length);
        }
    }

    /** Reads the rest of the line as one text: an operand that may hold blanks. */
    String readText(Command command) throws Rejected {
        readKeyword(command);
        if (!line.rest()) {
            throw reject(keywordTo, keywordTo + 1, "expected " + (command == Command.OUTPUT ? "a name" : "true or false")
                    + " after '" + keyword + "', found none");
        }
        from[0] = line.from;
        to[0] = line.to;
        return line.word();
    }

    private void readKeyword(Command command) {
        keyword = command.keyword();
        names = command.operands();
        keywordFrom = line.from;
        keywordTo = line.to;
    }

    private Rejected notANumber(int i, double value) {
        boolean hasComma = line.word().matches("[-+]?\\d*,\\d+");
        return reject(i, !Double.isNaN(value) ? "to be within a double's range (1.8e308)"
                : "to be a decimal number" + (hasComma ? " with a point, as " + line.word().replace(',', '.') : ""));
    }

    /** The line's current word is the first that is too many; or there is none, and some are missing. */
    private Rejected wrongCount(int read) {
        boolean tooMany = read == names.length;
        int start = tooMany ? line.from : read > 0 ? from[0] : keywordTo;
        int end = tooMany ? line.to : read > 0 ? to[read - 1] : keywordTo + 1;
        int found = read;
        if (tooMany) {
            do {
                found++;
                end = line.to;
            } while (line.nextWord());
        }
        return reject(start, end, "expected " + names.length + (names.length == 1 ? " number" : " numbers") + " after '"
                + keyword + "' (" + String.join(" ", names) + "), found " + found);
    }

    /** Where an operand starts in its line. */
    int column(int i) {
        return diagnostics.column(from[i]);
    }

    double number(int i) {
        return values[i];
    }

    double coordinate(int i) throws Rejected {
        if (!(Math.abs(values[i]) <= MAX_LENGTH)) {
            throw reject(i, "to be from -1e150 to 1e150");
        }
        return values[i];
    }

    double radius(int i) throws Rejected {
        if (!(values[i] > 0)) {
            throw reject(i, "to be more than 0");
        }
        if (!(values[i] >= MIN_LENGTH && values[i] <= MAX_LENGTH)) {
            throw reject(i, "to be from 1e-150 to 1e150");
        }
        return values[i];
    }

    /** Whether a displacement is so short that squares would lose it. */
    static boolean isTooShort(Vector v) {
        return Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z()))) < MIN_LENGTH;
    }

    /** A whole number within these bounds. */
    int whole(int i, int min, int max) throws Rejected {
        if (!isWhole(values[i], min, max)) {
            throw reject(i, "to be a whole number from " + min + " to " + max);
        }
        return (int) values[i];
    }

    /** The number of a vertex. */
    int vertex(int i, int declared) throws Rejected {
        if (!isWhole(values[i], 0, declared - 1)) {
            throw reject(i, "to be a vertex declared above, "
                    + (declared == 0 ? "of which there are none" : "from 0 to " + (declared - 1)));
        }
        return (int) values[i];
    }

    private static boolean isWhole(double value, int min, int max) {
        return value >= min && value <= max && value == Math.rint(value);
    }

    private Vector vector(int i) {
        return new Vector(values[i], values[i + 1], values[i + 2]);
    }

    Vector point(int i) throws Rejected {
        return new Vector(coordinate(i), coordinate(i + 1), coordinate(i + 2));
    }

    /** A vector that points somewhere. */
    Vector direction(int i) throws Rejected {
        if (values[i] == 0 && values[i + 1] == 0 && values[i + 2] == 0) {
            throw reject(from[i], to[i + 2], "expected " + names[i] + " " + names[i + 1] + " " + names[i + 2] + " of '"
                    + keyword + "' to have a length, found 0 0 0");
        }
        return vector(i);
    }

    Colour colour(int i) throws Rejected {
        return new Colour(notNegative(i), notNegative(i + 1), notNegative(i + 2));
    }

    private double notNegative(int i) throws Rejected {
        if (!(values[i] >= 0)) {
            throw reject(i, "to be 0 or more");
        }
        return values[i];
    }

    /** Reports that one operand is not what it should be. */
    Rejected reject(int i, String expectation) {
        return reject(from[i], to[i], "expected " + names[i] + " of '" + keyword + "' " + expectation + ", found "
                + diagnostics.quote(from[i], to[i]));
    }

    /** Reports what is wrong with a run of operands, as a sentence of its own. */
    Rejected rejectAll(int first, int last, String sentence) {
        return reject(from[first], to[last], sentence);
    }

    /** Reports what is wrong with the command as such. */
    Rejected rejectCommand(String sentence) {
        return reject(keywordFrom, keywordTo, sentence);
    }

    private Rejected reject(int start, int end, String sentence) {
        diagnostics.error(start, end, sentence);
        return REJECTED;
    }
}
