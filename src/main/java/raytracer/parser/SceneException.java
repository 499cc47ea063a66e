package raytracer.parser;

import java.util.List;

/** A scene file that breaks the format; it carries what to tell its author. */
public final class SceneException extends Exception {

    private static final long serialVersionUID = 1;

    private final transient List<Diagnostic> errors;
    private final long unlisted;
    private final boolean cutShort;

    SceneException(List<Diagnostic> errors, long unlisted, boolean cutShort) {
        super(errors.get(0).toString());
        this.errors = List.copyOf(errors);
        this.unlisted = unlisted;
        this.cutShort = cutShort;
    }

    /** The first errors, in the order of the file; at least one. */
    public List<Diagnostic> errors() {
        return errors;
    }

    /** How many errors the file has beyond those listed. */
    public long unlisted() {
        return unlisted;
    }

    /** Whether there were so many that the rest of the file was not read. */
    public boolean isCutShort() {
        return cutShort;
    }
}
