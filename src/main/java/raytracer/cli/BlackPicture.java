package raytracer.cli;

import raytracer.parser.ParsedScene;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.Explainer;
import raytracer.tracer.Tracer;

/** Finds out why a picture came out black, from what explains the pixels of a small one of the same scene. */
final class BlackPicture {

    /** Pixels along its longer side. */
    private static final int SIDE = 64;

    private final Scene scene;
    private boolean isAnySeen;
    private boolean isAnyColoured;
    private boolean isAnyTurned;

    private BlackPicture(Scene scene) {
        this.scene = scene;
    }

    static String reason(ParsedScene parsed) {
        Scene scene = parsed.scene();
        if (scene.lights().isEmpty() && scene.shapes().stream().allMatch(s -> s.material().ambient().isBlack())) {
            return "there is no light and no ambient colour";
        }
        BlackPicture picture = new BlackPicture(scene);
        picture.look();
        if (!picture.isAnySeen) {
            return "the camera sees nothing";
        }
        if (!picture.isAnyColoured) {
            return "nothing that is seen has a diffuse or ambient colour"
                    + (parsed.firstColourless() == 0 ? "" : "; colours hold for the shapes after them, and those from line "
                            + parsed.firstColourless() + " to line " + parsed.lastColourless() + " come before any");
        }
        return picture.isAnyTurned ? "the triangles that are seen show their backs, from where their corners go clockwise:"
                + " exchange two corners of each" : "all lights are behind the surfaces that are seen, or blocked";
    }

    private void look() {
        double scale = Math.min(1, (double) SIDE / Math.max(scene.width(), scene.height()));
        int width = (int) Math.ceil(scale * scene.width()), height = (int) Math.ceil(scale * scene.height());
        Explainer explainer = Tracer.compile(scene.withSize(width, height)).newExplainer();
        for (int pixel = 0; pixel < width * height; pixel++) {
            for (Explainer.Step step : explainer.explain(pixel % width, pixel / width).steps()) {
                if (step.hit() != null) {
                    look(step);
                }
            }
        }
    }

    private void look(Explainer.Step step) {
        Material material = step.hit().material();
        isAnySeen = true;
        isAnyColoured |= !material.diffuse().isBlack() || !material.ambient().isBlack();
        isAnyTurned |= step.hit().normal().dot(step.direction()) > 0 && isTriangle(step.hit().surface())
                && step.lights().stream().anyMatch(light -> !light.isFacing());
    }

    /** @param surface the surface's number in the order of declaration */
    private boolean isTriangle(int surface) {
        int end = 0;
        for (Shape shape : scene.shapes()) {
            end += shape.count();
            if (surface < end) {
                return shape instanceof Shape.Triangles;
            }
        }
        throw new IllegalArgumentException("there is no surface " + surface);
    }
}
