package raytracer.parser;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import raytracer.scene.Camera;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/**
 * Reads the text of a scene: one rule per command of the format. All validation happens here, once; a {@link Scene}
 * that comes out is finite, in range and well-formed. One parser reads one file.
 */
public final class SceneParser {

    private static final String DEFAULT_OUTPUT = "output.png";

    /** The longest side or count that an int holds. */
    private static final int MAX = Integer.MAX_VALUE;

    private final LineReader reader;
    private final Line line;
    private final Diagnostics diagnostics;
    private final Operands operands;

    /** Where a command that may be given once was given. */
    private final Map<Command, Long> lineOf = new EnumMap<>(Command.class);

    private final List<Light> lights = new ArrayList<>();
    private final ShapeList shapes = new ShapeList();
    private int width;
    private int height;
    private Camera camera;
    private int maxDepth = 1;
    private boolean shadow = true;
    private String output = DEFAULT_OUTPUT;
    private String outputPlace = "";
    private int maxVertices;
    private long emptyTriangles;
    private long firstEmptyTriangleLine;

    // Whether any colour but black has been declared; the lines of the shapes before that.
    private boolean anyColour;
    private long firstColourless;
    private long lastColourless;
    private double brightest;
    private long brightestLine;

    /**
     * Reads a whole scene.
     *
     * @param file what messages call the file
     * @param in   UTF-8 text, read to its end unless a line is too long; not closed
     * @throws SceneException if the text breaks the format
     * @throws IOException    if the stream fails
     */
    public static ParsedScene parse(String file, InputStream in) throws IOException, SceneException {
        return new SceneParser(file, in).parse();
    }

    /**
     * Reads a camera from the ten numbers of its command.
     *
     * @param name what messages call them
     */
    public static Camera camera(String name, String numbers) throws SceneException {
        String line = Command.CAMERA.keyword() + " " + numbers;
        SceneParser parser = new SceneParser(name, new ByteArrayInputStream(line.getBytes(StandardCharsets.UTF_8)));
        try {
            parser.reader.advance();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        parser.line.firstWord();
        parser.command();
        if (!parser.diagnostics.clean()) {
            throw parser.diagnostics.exception();
        }
        return parser.camera;
    }

    private SceneParser(String file, InputStream in) {
        reader = new LineReader(in);
        line = new Line(reader);
        diagnostics = new Diagnostics(file, reader);
        operands = new Operands(line, diagnostics);
    }

    private ParsedScene parse() throws IOException, SceneException {
        while (!diagnostics.isHopeless() && reader.advance()) {
            if (reader.number == 1 && diagnostics.isNoText()) {
                throw diagnostics.exception();
            }
            if (line.firstWord()) {
                command();
            }
        }
        if (reader.isTooLong) {
            diagnostics.error(reader.start, reader.start,
                    "expected a line of at most " + LineReader.LONGEST_LINE + " bytes, found a longer one");
        } else if (!diagnostics.isHopeless()) {
            require(Command.SIZE);
            require(Command.CAMERA);
        }
        if (!diagnostics.clean()) {
            throw diagnostics.exception();
        }
        Scene scene = new Scene(width, height, camera, maxDepth, shadow, lights, shapes.list(), shapes.mesh(), output);
        warn();
        return new ParsedScene(scene, diagnostics.warnings(), outputPlace,
                new ParsedScene.Colours(firstColourless, lastColourless, brightest, brightestLine));
    }

    private void require(Command command) {
        if (!lineOf.containsKey(command)) {
            diagnostics.errorOfFile("expected a '" + command.keyword() + " " + String.join(" ", command.operands())
                    + "' command in the file, found none");
        }
    }

    private void command() {
        Command command = Command.of(line.word());
        if (command == null) {
            diagnostics.unknownCommand(line.word(), line.from, line.to);
            Command near = Command.near(line.word());
            if (near != null) {
                recover(near);
            }
            return;
        }
        try {
            if (command != Command.OUTPUT && command != Command.SHADOW) {
                operands.read(command);
            }
            apply(command, operands);
        } catch (Operands.Rejected reported) {
            recover(command);
        }
    }

    // No table of lambdas: the first few that a program makes take longer than reading a small scene.
    private void apply(Command command, Operands o) throws Operands.Rejected {
        Material m = shapes.material();
        switch (command) {
            case SIZE -> {
                once(command, o);
                width = o.whole(0, 1, MAX);
                height = o.whole(1, 1, MAX);
            }
            case CAMERA -> camera(o);
            case OUTPUT -> output(o);
            case MAXDEPTH -> maxDepth = once(command, o).whole(0, 1, MAX);
            case SHADOW -> shadow(o);
            case AMBIENT -> shapes.material(new Material(coloured(o), m.diffuse(), m.specular(), m.shininess()));
            case DIFFUSE -> shapes.material(new Material(m.ambient(), coloured(o), m.specular(), m.shininess()));
            case SPECULAR -> shapes.material(new Material(m.ambient(), m.diffuse(), colour(o, 0), m.shininess()));
            case SHININESS -> shapes.material(new Material(m.ambient(), m.diffuse(), m.specular(), o.number(0)));
            case DIRECTIONAL -> lights.add(new Light.Directional(o.direction(0), colour(o, 3)));
            case POINT -> lights.add(new Light.Point(o.point(0), colour(o, 3)));
            case MAXVERTS -> maxVertices = once(command, o).whole(0, 0, MAX);
            case VERTEX -> vertex(o);
            case TRI -> triangle(o);
            case SPHERE -> shapes.add(new Shape.Sphere(o.point(0), o.radius(3), materialHere()));
            case PLANE -> shapes.add(new Shape.Plane(o.point(0), o.direction(3), materialHere()));
            default -> throw new IllegalStateException("there is no rule for " + command);
        }
    }

    private Colour coloured(Operands o) throws Operands.Rejected {
        Colour colour = colour(o, 0);
        anyColour |= !colour.isBlack();
        return colour;
    }

    private Colour colour(Operands o, int first) throws Operands.Rejected {
        Colour colour = o.colour(first);
        double max = Math.max(colour.red(), Math.max(colour.green(), colour.blue()));
        brightestLine = max > brightest ? reader.number : brightestLine;
        brightest = Math.max(max, brightest);
        return colour;
    }

    /** What a shape on this line is made of. */
    private Material materialHere() {
        if (!anyColour) {
            firstColourless = firstColourless == 0 ? reader.number : firstColourless;
            lastColourless = reader.number;
        }
        return shapes.material();
    }

    /** Keeps one mistake from being reported again by every line that builds on it. */
    private void recover(Command command) {
        switch (command) {
            case SIZE, CAMERA -> lineOf.putIfAbsent(command, reader.number);
            case MAXVERTS -> {
                lineOf.putIfAbsent(command, reader.number);
                maxVertices = MAX;
            }
            case VERTEX -> shapes.addVertex(0, 0, 0);
            default -> { }
        }
    }

    private Operands once(Command command, Operands o) throws Operands.Rejected {
        Long first = lineOf.putIfAbsent(command, reader.number);
        if (first != null) {
            throw o.rejectCommand("expected '" + command.keyword() + "' once, found it again (first on line " + first
                    + ")");
        }
        return o;
    }

    private void camera(Operands o) throws Operands.Rejected {
        once(Command.CAMERA, o);
        camera = new Camera(o.point(0), o.point(3), o.direction(6), o.number(9));
        Vector view = camera.eye().minus(camera.at());
        if (Operands.isTooShort(view)) {
            throw o.rejectAll(0, 5, "expected the eye (ex ey ez) and the point looked at (ax ay az) of 'camera'"
                    + " to differ" + (view.isZero() ? ", found them equal" : " by 1e-150 or more"));
        }
        if (!camera.upIsClear()) {
            throw o.rejectAll(6, 8, "expected up (ux uy uz) of 'camera' to differ from the direction of view,"
                    + " found them parallel");
        }
        if (!(camera.fov() > 0 && camera.fov() < 180)) {
            throw o.reject(9, "to be between 0 and 180 degrees");
        }
    }

    private void output(Operands o) throws Operands.Rejected {
        String name = o.readText(Command.OUTPUT);
        once(Command.OUTPUT, o);
        if (name.indexOf('\uFFFD') >= 0) {
            throw o.rejectAll(0, 0, "expected the name of 'output' in UTF-8, found bytes that are none: save the file as UTF-8");
        }
        output = name;
        outputPlace = ":" + reader.number + ":" + o.column(0);
    }

    private void shadow(Operands o) throws Operands.Rejected {
        String word = o.readText(Command.SHADOW);
        once(Command.SHADOW, o);
        if (!word.equals("true") && !word.equals("false")) {
            throw o.rejectAll(0, 0, "expected 'shadow' to be true or false, found '" + word + "'");
        }
        shadow = word.equals("true");
    }

    private void vertex(Operands o) throws Operands.Rejected {
        if (shapes.vertices() >= maxVertices) {
            if (!lineOf.containsKey(Command.MAXVERTS)) {
                maxVertices = MAX;
                throw o.rejectCommand("expected 'maxverts' before the first 'vertex', found none");
            }
            throw o.rejectCommand("expected at most " + maxVertices + " vertices ('maxverts' on line "
                    + lineOf.get(Command.MAXVERTS) + "), found one more");
        }
        shapes.addVertex(o.coordinate(0), o.coordinate(1), o.coordinate(2));
    }

    private void triangle(Operands o) throws Operands.Rejected {
        int declared = shapes.vertices();
        shapes.addTriangle(o.vertex(0, declared), o.vertex(1, declared), o.vertex(2, declared), materialHere());
        if (shapes.lastTriangleIsTooSmall()) {
            throw o.rejectAll(0, 2, "expected the corners of 'tri' to be 1e-150 or more apart, or equal");
        }
        if (shapes.lastTriangleIsEmpty() && emptyTriangles++ == 0) {
            firstEmptyTriangleLine = reader.number;
        }
    }

    private void warn() {
        if (emptyTriangles > 0) {
            diagnostics.warning(firstEmptyTriangleLine, emptyTriangles == 1
                    ? "this triangle has no area and is never seen"
                    : emptyTriangles + " triangles have no area and are never seen; this is the first");
        }
        if (shapes.vertices() < maxVertices) {
            diagnostics.warning(lineOf.get(Command.MAXVERTS),
                    "'maxverts' declares " + maxVertices + " vertices, but " + shapes.vertices() + " follow");
        }
    }
}
