package raytracer.cli;

import java.io.PrintStream;

/**
 * What people read: lines on standard output and standard error. Names and texts in them come from files, so whatever
 * a terminal would obey in them is shown as a replacement character.
 */
record Terminal(PrintStream out, PrintStream err) {

    /** An answer to what was asked for. */
    void answer(String text) {
        out.println(harmless(text));
    }

    /** Something about how it went. */
    void tell(String text) {
        err.println(harmless(text));
    }

    static String harmless(String text) {
        return text.replaceAll("[\\p{Cntrl}\\p{Cf}&&[^\n\t]]", "\uFFFD");
    }
}
