package raytracer.image;

/** The one place where a linear component becomes a byte. */
final class Quantiser {

    private Quantiser() { }

    /**
     * A component, cut to [0, 1], as {@link java.awt.Color#Color(float, float, float)} makes it a byte: the product is
     * one of floats. So decimals such as .3, half a step but for their own last bit, become what their author means.
     */
    static byte quantise(double component) {
        float product = (float) Math.min(1, Math.max(0, component)) * 255;
        return (byte) (int) (product + 0.5);
    }
}
