package raytracer.tracer;

import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;
import raytracer.text.Scenes;

/** Traces scenes that tests write down, to colours before they are cut and rounded. */
public final class Pictures {

    private Pictures() { }

    /** The colours, three doubles a pixel, row by row from the top. */
    public static double[] trace(Scene scene) {
        double[] colours = new double[3 * scene.width() * scene.height()];
        Region all = Region.whole(scene.width(), scene.height());
        new Renderer(Tracer.compile(scene, 2), Sampling.CENTRES, 1, all, (x, y, count, red, green, blue, from) -> {
            int i = 3 * (y * scene.width() + x);
            for (int k = from; k < from + count; k++) {
                colours[i++] = red[k];
                colours[i++] = green[k];
                colours[i++] = blue[k];
            }
        }).render();
        return colours;
    }

    public static double[] trace(String text) throws Exception {
        return trace(Scenes.parse(text).scene());
    }

    /** The colour of the single pixel of a camera at (0, 0, 5) that looks at the origin. */
    public static double[] middle(String text) throws Exception {
        return trace("size 1 1\ncamera 0 0 5 0 0 0 0 1 0 45\n" + text);
    }
}
