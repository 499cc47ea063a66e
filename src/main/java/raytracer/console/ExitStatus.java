package raytracer.console;

/** What the program ends with. */
public final class ExitStatus {

    /** All went well. */
    public static final int DONE = 0;

    /** Something failed that is not the user's text: no memory, a full disk, an unreadable file. */
    public static final int FAILED = 1;

    /** The command line or a scene is wrong. */
    public static final int BAD_INPUT = 2;

    /** The picture is not the one it was compared with. */
    public static final int DIFFERS = 3;

    private ExitStatus() { }
}
