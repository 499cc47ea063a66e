package raytracer.console;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** Figures as text that other programs read. */
public final class Json {

    private Json() { }

    /** @param value a map, a list, a text, a number or null; a number that is not whole gets four decimals */
    public static String of(Object value) {
        if (value instanceof Map<?, ?> map) {
            return map.entrySet().stream().map(e -> quoted(e.getKey().toString()) + ": " + of(e.getValue()))
                    .collect(Collectors.joining(", ", "{", "}"));
        }
        if (value instanceof List<?> list) {
            return list.stream().map(Json::of).collect(Collectors.joining(", ", "[", "]"));
        }
        return value instanceof Double number ? String.format(Locale.ROOT, "%.4f", number)
                : value == null || value instanceof Number ? String.valueOf(value) : quoted(value.toString());
    }

    /** The same of a map, an entry a line. */
    public static String lines(Map<String, Object> map) {
        return map.entrySet().stream().map(e -> "  " + quoted(e.getKey()) + ": " + of(e.getValue()))
                .collect(Collectors.joining(",\n", "{\n", "\n}\n"));
    }

    private static String quoted(String text) {
        return '"' + text.codePoints().mapToObj(c -> c == '"' || c == '\\' ? "\\" + Character.toString(c)
                : c < ' ' ? String.format(Locale.ROOT, "\\u%04x", c) : Character.toString(c)).collect(Collectors.joining()) + '"';
    }
}
