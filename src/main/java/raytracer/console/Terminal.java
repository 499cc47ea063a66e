package raytracer.console;

import java.io.PrintStream;

/**
 * What people read: lines on standard output and standard error. Names and texts in them come from files, so whatever
 * a terminal would obey in them is shown as a replacement character.
 */
public record Terminal(PrintStream out, PrintStream err) {

    /** An answer to what was asked for. */
    public void answer(String text) {
        out.println(harmless(text));
    }

    /** Something about how it went. */
    public void tell(String text) {
        err.println(harmless(text));
    }

    public static String harmless(String text) {
        return text.replaceAll("[\\p{Cntrl}\\p{Cf}&&[^\n\t]]", "\uFFFD");
    }
}
