package raytracer.parser;

/**
 * One thing to say about a scene file, built whole so that it can be printed at once.
 *
 * @param file    the name that the user knows the file by
 * @param line    from 1
 * @param column  in characters, from 1
 * @param message what was expected and what was found
 * @param excerpt the line and a caret under the place, two lines; empty if the place has no text
 */
public record Diagnostic(String file, long line, int column, String message, String excerpt) {

    /** {@code file:line:column: message}, and the excerpt below it if there is one; no line break at the end. */
    @Override
    public String toString() {
        return file + ":" + line + ":" + column + ": " + message + (excerpt.isEmpty() ? "" : "\n" + excerpt);
    }
}
