package raytracer.cli;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import raytracer.image.Image;
import raytracer.parser.Declarations;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.Explainer;
import raytracer.tracer.Tracer;

/** Says how a pixel gets its colour: every ray, what it hits, and what each light adds. */
final class Explaining {

    private static final MathContext DIGITS = new MathContext(6);

    private final String file;
    private final Declarations declarations;
    private final Scene scene;
    private final List<String> lines = new ArrayList<>();

    /** @param declarations of the scene, as its author wrote it in this file */
    Explaining(String file, Declarations declarations, Scene scene) {
        this.file = file;
        this.declarations = declarations;
        this.scene = scene;
    }

    /** The lines that explain a pixel of the picture. */
    List<String> explain(int x, int y) {
        Tracer tracer = Tracer.compile(scene);
        lines.add(file + ": pixel " + x + "," + y + " of " + scene.width() + "x" + scene.height());
        Explainer.Explanation explanation = tracer.newExplainer().explain(x, y);
        List<Explainer.Step> steps = explanation.steps();
        for (int i = 0; i < steps.size(); i++) {
            explain(i + 1, steps.get(i), i + 1 == steps.size());
        }
        Colour colour = explanation.colour();
        Image pixel = new Image(1, 1);
        pixel.setPixels(0, 0, 1, 1, new double[] {colour.red()}, new double[] {colour.green()},
                new double[] {colour.blue()});
        int rgb = pixel.rgb(0, 0);
        lines.add("colour " + text(colour) + " -> " + (rgb >> 16) + " " + (rgb >> 8 & 255) + " " + (rgb & 255));
        return lines;
    }

    private void explain(int number, Explainer.Step step, boolean isLast) {
        lines.add(String.format("%-3d", number) + (number == 1 ? "ray from the eye " : "mirrored ray from ")
                + text(step.origin()) + " towards " + text(step.direction())
                + (number == 1 ? "" : ", of which " + text(step.weight()) + " reaches the pixel"));
        Explainer.Hit hit = step.hit();
        if (hit == null) {
            add("hits nothing: black");
            return;
        }
        add("hits " + shape(hit.surface()) + " at distance " + text(hit.distance()) + ", point " + text(hit.point())
                + ", normal " + text(hit.normal()));
        for (int other : step.asNear()) {
            add("as near as " + shape(other) + ", within rounding: the first declared is seen");
        }
        add("ambient   " + text(hit.material().ambient()));
        for (int i = 0; i < declarations.lights().size(); i++) {
            add(text(declarations.lights().get(i)) + " " + (step.lights().isEmpty()
                    ? "adds nothing: 'diffuse' and 'specular' are black" : step.lights().get(i).isFacing()
                    ? text(step.lights().get(i)) : "adds nothing: " + whyNothing(number, step, scene.lights().get(i))));
        }
        Colour mirror = hit.material().specular();
        add("mirror    " + text(mirror) + (mirror.isBlack() ? ": none, as 'specular' is black"
                : number == scene.maxDepth() ? ": not followed, as maxdepth is " + number
                : isLast ? ": not followed, as it can change the pixel no more" : " of what the next ray brings"));
    }

    /** Why a light that is not blocked adds nothing. */
    private String whyNothing(int number, Explainer.Step step, Light light) {
        Explainer.Hit hit = step.hit();
        Shape shape = scene.shape(hit.surface());
        if (shape instanceof Shape.Sphere && hit.normal().dot(step.direction()) > 0) {
            return "the " + (number == 1 ? "eye" : "ray") + " is inside " + shape(hit.surface());
        }
        boolean isInside = shape instanceof Shape.Sphere sphere && light instanceof Light.Point point
                && point.position().minus(sphere.centre()).length() < sphere.radius();
        return isInside ? "it is inside " + shape(hit.surface()) : "it is behind the surface";
    }

    private void add(String line) {
        lines.add("   " + line);
    }

    private String shape(int number) {
        return text(declarations.shapes().get(number));
    }

    private String text(Declarations.Place place) {
        return place.command() + " (" + file + ":" + place.line() + ")";
    }

    private String text(Explainer.Lit light) {
        if (light.isBlocked()) {
            return "blocked by " + (light.blocker() < 0 ? "a surface that is here within rounding"
                    : shape(light.blocker()) + " at " + text(light.blockedAt()))
                    + (Double.isInfinite(light.distance()) ? "" : " of " + text(light.distance()));
        }
        return "adds diffuse " + text(light.diffuse()) + " and highlight " + text(light.highlight());
    }

    private static String text(Vector v) {
        return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
    }

    private static String text(Colour c) {
        return text(new Vector(c.red(), c.green(), c.blue()));
    }

    /** With six digits. */
    private static String text(double value) {
        if (value == 0 || !Double.isFinite(value)) {
            return value == 0 ? "0" : String.valueOf(value);
        }
        BigDecimal rounded = new BigDecimal(value).round(DIGITS).stripTrailingZeros();
        double size = Math.abs(value);
        return size >= 1e-4 && size < 1e9 ? rounded.toPlainString() : rounded.toString();
    }
}
