package raytracer.parser;

import java.util.List;

/** A scene file that breaks the format; it carries what to tell its author. */
public final class SceneException extends Exception {

    private static final long serialVersionUID = 1;

    private final transient List<Diagnostic> errors;
    private final long count;
    private final String rest;

    SceneException(List<Diagnostic> errors, long count, String rest) {
        super(errors.get(0).toString());
        this.errors = List.copyOf(errors);
        this.count = count;
        this.rest = rest;
    }

    /** The first errors, in the order of the file; at least one. */
    public List<Diagnostic> errors() {
        return errors;
    }

    /** How many errors there are in all. */
    public long count() {
        return count;
    }

    /** What there is beyond those, in words; empty if nothing. */
    public String rest() {
        return rest;
    }
}
