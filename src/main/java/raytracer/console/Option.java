package raytracer.console;

import java.util.Locale;
import java.util.stream.Stream;
import raytracer.files.UsageException;
import raytracer.parser.Spelling;

/** The options of the command line, and what the help says of each. */
public enum Option {

    OUTPUT("FILE", "write here, not to the scene's 'output'; - for stdout"),
    SIZE("WxH", "override the scene's size"),
    CAMERA("LINE", "another camera: \"ex ey ez  ax ay az  ux uy uz  fov\""),
    MAXDEPTH("N", "override the scene's maxdepth"),
    SAMPLES("N", "N x N samples a pixel, 1 to 64; 1 is the reference",
            "auto:E", "as many as an error of E takes, 1/510 or more (1/255)"),
    REGION("X,Y,W,H", "render only this part of the picture"),
    THREADS("N", "use N threads instead of one per core"),
    COMPARE("FILE", "compare with this picture; SCENE may be a picture too",
            "FOLDER", "compare each SCENE with NAME.png in there"),
    DIFF("FILE", "show differences here; else beside, in NAME-diff.png"),
    TOLERANCE("N", "by how much components may differ, 0 to 255"),
    EXPLAIN("X,Y", "tell how this pixel gets its colour; no picture"),
    WATCH("", "render again whenever a scene is saved, until Ctrl-C"),
    CHART("FILE.svg", "chart time against error for this scene; no picture"),
    CHART_SECONDS("N", "how long to measure for it, about (60)"),
    QUIET("", "no progress and no summary; errors and warnings stay"),
    VERBOSE("", "tell what was read and built, and how fast it went"),
    REPEAT("N", "render N times in this process, write once"),
    STATS("FILE", "write figures as JSON"),
    CHECK("", "parse and validate only, write nothing"),
    HELP("", "this text; --version prints the version"),
    VERSION;

    private final String[] forms;

    /** @param forms what the value is called, empty if there is none; what it does; and so on for each kind of value */
    Option(String... forms) {
        this.forms = forms;
    }

    public boolean takesValue() {
        return forms.length > 0 && !forms[0].isEmpty();
    }

    /** {@code --chart-seconds} */
    public String flag() {
        return "--" + name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The option of this flag. */
    public static Option of(String flag) throws UsageException {
        for (Option option : values()) {
            if (flag.equals(option.flag()) || flag.equals(option.shortFlag())) {
                return option;
            }
        }
        String near = Spelling.nearest(flag, Stream.of(values()).map(Option::flag).toList());
        throw new UsageException("unknown option '" + flag + "'" + (near == null ? "; see --help" : "; did you mean '" + near
                + "'?"));
    }

    static boolean isFlag(String text) {
        return Stream.of(values()).anyMatch(option -> text.equals(option.flag()) || text.equals(option.shortFlag()));
    }

    private String shortFlag() {
        return this == OUTPUT ? "-o" : this == HELP ? "-h" : "";
    }

    /** What {@code --help} prints. */
    public static String help() {
        StringBuilder text = new StringBuilder(
                "usage: raytracer [options] SCENE...       SCENE may be - for standard input\n");
        for (Option option : values()) {
            String alias = option.shortFlag().isEmpty() ? "    " : option.shortFlag() + ", ";
            for (int form = 0; form < option.forms.length; form += 2) {
                text.append(String.format(Locale.ROOT, "  %s%-18s %s%n", alias,
                        option.flag() + " " + option.forms[form], option.forms[form + 1]));
            }
        }
        return text.append("exit status: 0 done, 1 failed, 2 bad usage or scene, 3 pictures differ\n").toString();
    }
}
