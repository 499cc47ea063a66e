package raytracer.tracer;

import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Scene;

/** Traces scenes that tests write down, to colours before they are cut and rounded. */
public final class Pictures {

    private Pictures() { }

    /** The colours, three doubles a pixel, row by row from the top. */
    public static double[] trace(Scene scene) {
        double[] colours = new double[3 * scene.width() * scene.height()];
        Region all = Region.whole(scene.width(), scene.height());
        new Renderer(Tracer.compile(scene), Sampling.CENTRES, 1, all, (x, y, columns, rows, red, green, blue) -> {
            for (int k = 0; k < columns * rows; k++) {
                int i = 3 * ((y + k / columns) * scene.width() + x + k % columns);
                colours[i] = red[k];
                colours[i + 1] = green[k];
                colours[i + 2] = blue[k];
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
