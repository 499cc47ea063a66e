package raytracer.parser;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Parses scenes that tests write down. */
public final class Scenes {

    private Scenes() { }

    public static ParsedScene parse(String text) throws Exception {
        return SceneParser.parse("test.scene", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    static List<String> warnings(String text) throws Exception {
        return parse(text).warnings().stream().map(Diagnostic::toString).toList();
    }
}
