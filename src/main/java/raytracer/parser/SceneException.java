package raytracer.parser;

import java.util.List;

/** A scene file that breaks the format; it carries what to tell its author. */
public final class SceneException extends Exception {

    private static final long serialVersionUID = 1;

    private final transient List<Diagnostic> errors;
    private final String rest;

    SceneException(List<Diagnostic> errors, String rest) {
        super(errors.get(0).toString());
        this.errors = List.copyOf(errors);
        this.rest = rest;
    }

    /** The first errors, in the order of the file; at least one. */
    public List<Diagnostic> errors() {
        return errors;
    }

    /** What there is beyond those, in words; empty if nothing. */
    public String rest() {
        return rest;
    }
}
