package raytracer.text;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import raytracer.scene.Camera;
import raytracer.scene.Light;
import raytracer.scene.Scene;
import raytracer.scene.Shape;

/**
 * Reads the text of a scene: one rule per command of the format. All validation happens here, once; a {@link Scene}
 * that comes out is finite, in range and well-formed. One parser reads one file.
 */
public final class SceneParser {

    private static final String DEFAULT_OUTPUT = "output.png";

    /** The longest side or count that an int holds. */
    private static final int MOST = Integer.MAX_VALUE;

    private interface Rule {
        void apply(Operands operands) throws Operands.Rejected;
    }

    private final LineReader reader;
    private final Line line;
    private final Diagnostics diagnostics;
    private final Operands operands;
    private final CommandTable<Rule> commands = new CommandTable<>();
    private final Map<String, Long> lineOf = new HashMap<>();

    private final MaterialState material = new MaterialState();
    private final List<Light> lights = new ArrayList<>();
    private final ShapeList shapes = new ShapeList();
    private int width;
    private int height;
    private Camera camera;
    private int maxDepth = 1;
    private String output = DEFAULT_OUTPUT;
    private int maxVertices;
    private long emptyTriangles;
    private long firstEmptyTriangleLine;

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

    private SceneParser(String file, InputStream in) {
        reader = new LineReader(in);
        line = new Line(reader);
        diagnostics = new Diagnostics(file, reader);
        operands = new Operands(line, diagnostics);
        commands.add("size", "w h", this::size);
        commands.add("camera", "ex ey ez ax ay az ux uy uz fov", this::camera);
        commands.addText("output", "name", this::output);
        commands.add("maxdepth", "n", this::maxDepth);
        commands.add("ambient", "r g b", o -> material.ambient(o.colour(0)));
        commands.add("diffuse", "r g b", o -> material.diffuse(o.colour(0)));
        commands.add("specular", "r g b", o -> material.specular(o.colour(0)));
        commands.add("shininess", "s", o -> material.shininess(o.number(0)));
        commands.add("directional", "x y z r g b", o -> lights.add(new Light.Directional(o.direction(0), o.colour(3))));
        commands.add("point", "x y z r g b", o -> lights.add(new Light.Point(o.vector(0), o.colour(3))));
        commands.add("maxverts", "n", this::maxVertices);
        commands.add("vertex", "x y z", this::vertex);
        commands.add("tri", "i j k", this::triangle);
        commands.add("sphere", "x y z r", this::sphere);
        commands.add("plane", "x y z nx ny nz", this::plane);
    }

    private ParsedScene parse() throws IOException, SceneException {
        while (reader.advance()) {
            if (line.firstWord()) {
                command();
            }
        }
        if (reader.tooLong()) {
            diagnostics.error(reader.start(), reader.start(),
                    "expected a line of at most " + LineReader.LONGEST_LINE + " bytes, found a longer one");
        } else {
            require("size", "size w h");
            require("camera", "camera ex ey ez ax ay az ux uy uz fov");
        }
        if (!diagnostics.clean()) {
            throw diagnostics.exception();
        }
        Scene scene = new Scene(width, height, camera, maxDepth, lights, shapes.list(), shapes.mesh(), output);
        warn(scene);
        return new ParsedScene(scene, diagnostics.warnings());
    }

    private void require(String keyword, String usage) {
        if (!lineOf.containsKey(keyword)) {
            diagnostics.errorAtEnd("expected a '" + usage + "' command in the file, found none");
        }
    }

    private void command() {
        CommandTable.Command<Rule> command = commands.find(line);
        if (command == null) {
            diagnostics.error(line.from(), line.to(), "expected a command, found "
                    + diagnostics.quote(line.from(), line.to()) + commands.suggestion(line.word()));
            return;
        }
        try {
            if (!command.text()) {
                operands.read(command.keyword(), command.operands());
            }
            command.rule().apply(operands);
        } catch (Operands.Rejected reported) {
            recover(command.keyword());
        }
    }

    /** Keeps one mistake from being reported again by every line that builds on it. */
    private void recover(String keyword) {
        switch (keyword) {
            case "size", "camera" -> lineOf.putIfAbsent(keyword, reader.number());
            case "maxverts" -> {
                lineOf.putIfAbsent(keyword, reader.number());
                maxVertices = MOST;
            }
            case "vertex" -> shapes.addVertex(0, 0, 0);
            default -> { }
        }
    }

    private void once(String keyword, Operands o) throws Operands.Rejected {
        Long first = lineOf.putIfAbsent(keyword, reader.number());
        if (first != null) {
            throw o.rejectCommand("expected '" + keyword + "' once, found it again (first on line " + first + ")");
        }
    }

    private void size(Operands o) throws Operands.Rejected {
        once("size", o);
        width = o.whole(0, 1, MOST);
        height = o.whole(1, 1, MOST);
    }

    private void camera(Operands o) throws Operands.Rejected {
        once("camera", o);
        camera = new Camera(o.vector(0), o.vector(3), o.vector(6), o.number(9));
        if (camera.eye().minus(camera.at()).isZero()) {
            throw o.rejectAll(0, 5, "expected the eye (ex ey ez) and the point looked at (ax ay az) of 'camera'"
                    + " to differ, found them equal");
        }
        o.direction(6);
        if (!camera.upIsClear()) {
            throw o.rejectAll(6, 8, "expected up (ux uy uz) of 'camera' to differ from the direction of view,"
                    + " found them parallel");
        }
        if (!(camera.fov() > 0 && camera.fov() < 180)) {
            throw o.reject(9, "to be between 0 and 180 degrees");
        }
    }

    private void output(Operands o) throws Operands.Rejected {
        String name = o.readText("output", new String[] {"name"});
        once("output", o);
        output = name;
    }

    private void maxDepth(Operands o) throws Operands.Rejected {
        once("maxdepth", o);
        maxDepth = o.whole(0, 1, MOST);
    }

    private void maxVertices(Operands o) throws Operands.Rejected {
        once("maxverts", o);
        maxVertices = o.whole(0, 0, MOST);
    }

    private void vertex(Operands o) throws Operands.Rejected {
        if (shapes.vertices() >= maxVertices) {
            throw o.rejectCommand(lineOf.containsKey("maxverts")
                    ? "expected at most " + maxVertices + " vertices ('maxverts' on line " + lineOf.get("maxverts")
                            + "), found one more"
                    : "expected 'maxverts' before the first 'vertex', found none");
        }
        shapes.addVertex(o.number(0), o.number(1), o.number(2));
    }

    private void triangle(Operands o) throws Operands.Rejected {
        int declared = shapes.vertices();
        shapes.addTriangle(o.vertex(0, declared), o.vertex(1, declared), o.vertex(2, declared), material.current());
        if (shapes.lastTriangleIsEmpty() && emptyTriangles++ == 0) {
            firstEmptyTriangleLine = reader.number();
        }
    }

    private void sphere(Operands o) throws Operands.Rejected {
        shapes.add(new Shape.Sphere(o.vector(0), o.positive(3), material.current()));
    }

    private void plane(Operands o) throws Operands.Rejected {
        shapes.add(new Shape.Plane(o.vector(0), o.direction(3), material.current()));
    }

    private void warn(Scene scene) {
        if (emptyTriangles > 0) {
            diagnostics.warning(firstEmptyTriangleLine, emptyTriangles == 1
                    ? "this triangle has no area and is never seen"
                    : emptyTriangles + " triangles have no area and are never seen; this is the first");
        }
        if (shapes.vertices() < maxVertices) {
            diagnostics.warning(lineOf.get("maxverts"),
                    "'maxverts' declares " + maxVertices + " vertices, but " + shapes.vertices() + " follow");
        }
        Visibility.darkness(scene).ifPresent(reason -> diagnostics.warning(0, reason + ": the picture is black"));
    }
}
