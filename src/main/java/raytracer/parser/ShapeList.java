package raytracer.parser;

import java.util.ArrayList;
import java.util.List;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Shape;
import raytracer.scene.Vector;

/**
 * The shapes in the order of declaration, and the material commands in force, whose values each shape takes that is
 * declared after them. Triangles that follow one another in one material become one run.
 */
final class ShapeList {

    private final List<Shape> shapes = new ArrayList<>();
    private final Mesh.Builder mesh = new Mesh.Builder();
    private Material current = new Material(Colour.BLACK, Colour.BLACK, Colour.BLACK, 1);
    private int runStart;
    private Material runMaterial;

    void add(Shape shape) {
        endRun();
        shapes.add(shape);
    }

    void addVertex(double x, double y, double z) {
        mesh.addVertex(x, y, z);
    }

    void addTriangle(int a, int b, int c, Material material) {
        if (runMaterial != material) {
            endRun();
            runMaterial = material;
        }
        mesh.addTriangle(a, b, c);
    }

    private void endRun() {
        if (runMaterial != null) {
            shapes.add(new Shape.Triangles(runStart, mesh.triangles() - runStart, runMaterial));
        }
        runStart = mesh.triangles();
        runMaterial = null;
    }

    int vertices() {
        return mesh.vertices();
    }

    /** Whether the corners of the triangle added last lie on a line, as far as doubles can tell. */
    boolean lastTriangleIsEmpty() {
        return edge(1).cross(edge(2)).isZero();
    }

    /** Whether the triangle added last is so small that its area is lost, though its corners are not equal. */
    boolean lastTriangleIsTooSmall() {
        return Operands.isTooShort(edge(1)) && Operands.isTooShort(edge(2)) && !(edge(1).isZero() && edge(2).isZero());
    }

    /** From the first corner of the triangle added last to another. */
    private Vector edge(int corner) {
        return mesh.corner(corner).minus(mesh.corner(0));
    }

    List<Shape> list() {
        endRun();
        return shapes;
    }

    Mesh mesh() {
        return mesh.build();
    }

    /** What a shape is made of that is declared now: the same object for as long as no value changes. */
    Material material() {
        return current;
    }

    void material(Material now) {
        if (!now.equals(current)) {
            current = now;
        }
    }
}
