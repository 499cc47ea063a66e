package raytracer.cli;

import raytracer.console.ExitStatus;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Reference;

/** Says how a picture compares with its reference. */
final class Comparing {

    private Comparing() { }

    /** Returns the exit status. */
    static int tell(Reference.Verdict verdict, Options options, Outputs outputs, Terminal terminal) {
        String prefix = options.scenes().size() > 1 ? outputs.input().name() + ": " : "";
        if (outputs.isPictureOnStandardOutput()) {
            terminal.tell(prefix + verdict.words());
        } else {
            terminal.answer(prefix + verdict.words());
        }
        boolean canExplain = outputs.destination() != null && !options.has(Option.REGION) && !options.has(Option.SAMPLES);
        if (canExplain && verdict.comparison() != null && !verdict.isPassed()) {
            terminal.tell(prefix + "how the most different pixel gets its colour: --explain "
                    + verdict.comparison().x() + "," + verdict.comparison().y());
        }
        return verdict.isPassed() ? ExitStatus.DONE : ExitStatus.DIFFERS;
    }
}
