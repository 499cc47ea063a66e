package raytracer.tracer;

import raytracer.scene.Scene;
import raytracer.text.Scenes;

/** Traces scenes that tests write down, to colours before they are cut and rounded. */
public final class Pictures {

    private Pictures() { }

    /** The colours, three doubles a pixel, row by row from the top. */
    public static double[] trace(Scene scene) {
        double[] colours = new double[3 * scene.width() * scene.height()];
        TileTracer tracer = Tracer.compile(scene, 2).newTileTracer();
        for (int top = 0; top < scene.height(); top += Tracer.TILE_SIDE) {
            for (int left = 0; left < scene.width(); left += Tracer.TILE_SIDE) {
                tracer.trace(left, top, Math.min(Tracer.TILE_SIDE, scene.width() - left),
                        Math.min(Tracer.TILE_SIDE, scene.height() - top), (x, y, red, green, blue) -> {
                            int i = 3 * (y * scene.width() + x);
                            colours[i] = red;
                            colours[i + 1] = green;
                            colours[i + 2] = blue;
                        });
            }
        }
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
