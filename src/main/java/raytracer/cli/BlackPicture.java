package raytracer.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import raytracer.image.Image;
import raytracer.parser.ParsedScene;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.Tracer;

/** Finds out why a picture came out black, by small pictures of the same scene with something changed. */
final class BlackPicture {

    /** Pixels along the longer side of a trial's picture. */
    private static final int SIDE = 64;

    private static final Colour WHITE = new Colour(1, 1, 1);

    private BlackPicture() { }

    static String reason(ParsedScene parsed) {
        Scene scene = parsed.scene();
        if (scene.lights().isEmpty() && scene.shapes().stream().allMatch(s -> s.material().ambient().isBlack())) {
            return "there is no light and no ambient colour";
        }
        if (isBlack(shining(scene, material -> WHITE))) {
            return "the camera sees nothing";
        }
        if (isBlack(shining(scene, m -> m.diffuse().isBlack() && m.ambient().isBlack() ? Colour.BLACK : WHITE))) {
            return "nothing that is seen has a diffuse or ambient colour"
                    + (parsed.firstColourless() == 0 ? "" : "; colours hold for the shapes after them, and those from line "
                            + parsed.firstColourless() + " to line " + parsed.lastColourless() + " come before any");
        }
        if (!isBlack(turned(scene))) {
            return "the triangles that are seen show their backs, from where their corners go clockwise:"
                    + " exchange two corners of each";
        }
        return "all lights are behind the surfaces that are seen, or blocked";
    }

    private static boolean isBlack(Scene scene) {
        double scale = Math.min(1, (double) SIDE / Math.max(scene.width(), scene.height()));
        int width = (int) Math.ceil(scale * scene.width()), height = (int) Math.ceil(scale * scene.height());
        Image image = new Image(width, height);
        new Renderer(Tracer.compile(scene.withSize(width, height)), Sampling.CENTRES, 1, Region.whole(width, height),
                image).render();
        return image.isBlack();
    }

    /** The scene without lights, its surfaces shining by themselves. */
    private static Scene shining(Scene scene, Function<Material, Colour> colour) {
        UnaryOperator<Material> shining = m -> new Material(colour.apply(m), Colour.BLACK, Colour.BLACK, 1);
        return with(scene, List.of(), scene.mesh(), shining);
    }

    /** The scene with its triangles turned round. */
    private static Scene turned(Scene scene) {
        Mesh.Builder turned = new Mesh.Builder();
        for (int triangle = 0; triangle < scene.mesh().triangles(); triangle++) {
            for (int corner = 2; corner >= 0; corner--) {
                turned.addVertex(scene.mesh().coordinate(triangle, corner, 0),
                        scene.mesh().coordinate(triangle, corner, 1), scene.mesh().coordinate(triangle, corner, 2));
            }
            turned.addTriangle(3 * triangle, 3 * triangle + 1, 3 * triangle + 2);
        }
        return with(scene, scene.lights(), turned.build(), material -> material);
    }

    private static Scene with(Scene scene, List<Light> lights, Mesh mesh, UnaryOperator<Material> materials) {
        List<Shape> shapes = new ArrayList<>();
        for (Shape shape : scene.shapes()) {
            Material material = materials.apply(shape.material());
            if (shape instanceof Shape.Sphere sphere) {
                shapes.add(new Shape.Sphere(sphere.centre(), sphere.radius(), material));
            } else if (shape instanceof Shape.Plane plane) {
                shapes.add(new Shape.Plane(plane.point(), plane.normal(), material));
            } else if (shape instanceof Shape.Triangles run) {
                shapes.add(new Shape.Triangles(run.first(), run.count(), material));
            }
        }
        return new Scene(scene.width(), scene.height(), scene.camera(), scene.maxDepth(), lights, shapes, mesh,
                scene.output());
    }
}
