package raytracer.cli;

import java.awt.image.BufferedImage;
import java.io.IOException;
import raytracer.console.Option;
import raytracer.console.Options;
import raytracer.console.Terminal;
import raytracer.files.Reference;

/** Compares a picture with a reference, which has been read before the picture is made, and says how they differ. */
final class Comparing {

    private final Outputs outputs;
    private final Reference reference;
    private final String prefix;
    private final Terminal terminal;
    private final boolean canExplain;

    Comparing(Options options, Outputs outputs, int width, int height, Terminal terminal) throws IOException {
        this.outputs = outputs;
        this.terminal = terminal;
        canExplain = outputs.destination() != null && !options.has(Option.REGION) && !options.has(Option.SAMPLES);
        prefix = options.scenes().size() > 1 ? outputs.input().name() + ": " : "";
        reference = Reference.read(
                outputs.reference(), width, height, options.whole(Option.TOLERANCE, 0), outputs.difference());
    }

    Reference.Verdict compare(BufferedImage actual) throws IOException {
        Reference.Verdict verdict = reference.compare(actual);
        if (outputs.isPictureOnStandardOutput()) {
            terminal.tell(prefix + verdict.words());
        } else {
            terminal.answer(prefix + verdict.words());
        }
        if (canExplain && verdict.comparison() != null && !verdict.isPassed()) {
            terminal.tell(prefix + "how the most different pixel gets its colour: --explain "
                    + verdict.comparison().x() + "," + verdict.comparison().y());
        }
        return verdict;
    }

    static int status(Reference.Verdict verdict) {
        return verdict.isPassed() ? Main.DONE : Main.DIFFERS;
    }
}
