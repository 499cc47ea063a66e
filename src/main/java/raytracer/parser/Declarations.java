package raytracer.parser;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Where a valid scene declares its shapes and lights, in the order of declaration: found again only when asked for, so
 * that a scene that is rendered need not keep it.
 */
public record Declarations(List<Place> shapes, List<Place> lights) {

    /**
     * @param command {@code sphere}, {@code plane}, {@code tri}, {@code point} or {@code directional}
     * @param line    from 1
     */
    public record Place(String command, long line) { }

    public static Declarations of(byte[] scene) throws IOException {
        Declarations all = new Declarations(new ArrayList<>(), new ArrayList<>());
        LineReader reader = new LineReader(new ByteArrayInputStream(scene));
        Line line = new Line(reader);
        while (reader.advance()) {
            Command command = line.firstWord() ? Command.of(line.word()) : null;
            if (command == Command.SPHERE || command == Command.PLANE || command == Command.TRI) {
                all.shapes.add(new Place(command.keyword(), reader.number));
            } else if (command == Command.POINT || command == Command.DIRECTIONAL) {
                all.lights.add(new Place(command.keyword(), reader.number));
            }
        }
        return all;
    }
}
