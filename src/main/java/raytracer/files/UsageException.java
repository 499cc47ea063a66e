package raytracer.files;

/** A command line that makes no sense, or a scene that asks for what it may not; the message says why. */
public final class UsageException extends Exception {

    private static final long serialVersionUID = 1;

    /** {@code :line:column} in the scene's file; empty if it is not about a place there. */
    private final String place;

    public UsageException(String message) {
        this("", message);
    }

    public UsageException(String place, String message) {
        super(message);
        this.place = place;
    }

    public String place() {
        return place;
    }
}
