package raytracer.cli;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import raytracer.image.Image;
import raytracer.parser.ParsedScene;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Material;
import raytracer.scene.Scene;
import raytracer.tracer.Tracer;

/**
 * Why a picture came out black, or nearly white: found out from others of the same scene, in simpler materials, of which the
 * first that is not what it should be names the cause. Without lights and mirrors they take less time than the picture.
 */
final class PictureAdvice {

    /** Pixels along the longer side of a picture with lights. */
    private static final int SIDE = 64;

    private static final Colour WHITE = new Colour(1, 1, 1);

    private final Tracer tracer;
    private final int threads;

    private PictureAdvice(Tracer tracer, int threads) {
        this.tracer = tracer;
        this.threads = threads;
    }

    /**
     * What to say of a picture of one sample a pixel; null if nothing.
     *
     * @param cutPixels how many of its pixels have a component that is cut at 1
     */
    static String of(Image image, long cutPixels, ParsedScene.Colours colours, Tracer tracer, int threads) {
        if (image.isBlack()) {
            return "the picture is black: " + new PictureAdvice(tracer, threads).whyBlack(colours);
        }
        return 2 * cutPixels <= (long) tracer.width() * tracer.height() ? null : "most of the picture is cut at 1: "
                + (colours.brightest() > 1 ? "a colour on line " + colours.brightestLine() + " goes up to " + colours.brightest()
                        + ", and they are meant to be from 0 to 1" : "the lights add up to more");
    }

    private String whyBlack(ParsedScene.Colours colours) {
        List<Light> lights = tracer.scene().lights();
        if (lights.isEmpty() && Stream.of(tracer.table().materials()).allMatch(m -> m.ambient().isBlack())) {
            return "there is no light and no ambient colour";
        }
        if (isBlack(m -> WHITE)) {
            return "the camera sees nothing";
        }
        if (isBlack(m -> present(m.diffuse().isBlack() ? m.ambient() : m.diffuse()))) {
            return "nothing that is seen has a diffuse or ambient colour" + (colours.firstColourless() == 0 ? ""
                    : "; colours hold for the shapes after them, and " + (colours.firstColourless() == colours.lastColourless()
                            ? "that on line " + colours.firstColourless() + " comes"
                            : "those from line " + colours.firstColourless() + " to line " + colours.lastColourless() + " come")
                            + " before any");
        }
        double red = 0, green = 0, blue = 0;
        for (Light light : lights) {
            red += light.colour().red();
            green += light.colour().green();
            blue += light.colour().blue();
        }
        Colour light = new Colour(red, green, blue);
        if (isBlack(m -> present(new Colour(light.red() * m.diffuse().red(), light.green() * m.diffuse().green(),
                light.blue() * m.diffuse().blue())))) {
            return lights.isEmpty() ? "there is no light, and nothing that is seen has an ambient colour"
                    : "what is seen returns no colour that a light has";
        }
        return isSeenWithMeshTurned() ? "the triangles that are seen show their backs, from where their corners go clockwise:"
                + " exchange two corners of each" : "all lights are behind the surfaces that are seen, or blocked";
    }

    /** Full where a component is there at all. */
    private static Colour present(Colour c) {
        return new Colour(Math.signum(c.red()), Math.signum(c.green()), Math.signum(c.blue()));
    }

    /** Whether the picture is black if surfaces have nothing but some ambient colour. */
    private boolean isBlack(Function<Material, Colour> ambient) {
        Material[] materials = Arrays.stream(tracer.table().materials())
                .map(m -> new Material(ambient.apply(m), Colour.BLACK, Colour.BLACK, 1)).toArray(Material[]::new);
        return render(tracer.withMaterials(materials).withMaxDepth(1)).isBlack();
    }

    /** Whether a small picture shows anything if all triangles show their other side. */
    private boolean isSeenWithMeshTurned() {
        Scene scene = tracer.scene();
        double scale = Math.min(1, (double) SIDE / Math.max(scene.width(), scene.height()));
        return scene.mesh().triangles() > 0 && !render(Tracer.compile(scene.withMeshTurned().withSize(
                (int) Math.ceil(scale * scene.width()), (int) Math.ceil(scale * scene.height())))).isBlack();
    }

    private Image render(Tracer simpler) {
        Image image = new Image(simpler.width(), simpler.height());
        new Renderer(simpler, Sampling.CENTRES, threads, Region.whole(simpler.width(), simpler.height()), image).render();
        return image;
    }
}
