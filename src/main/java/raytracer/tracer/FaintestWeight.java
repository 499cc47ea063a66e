package raytracer.tracer;

import java.util.List;
import java.util.function.ToDoubleFunction;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.tracer.rays.LightSource;

/**
 * By component, the weight up to which a path can change no byte of its pixel any more, whatever it still hits. A hit adds
 * at most what some material sends back if it faces all lights, and each mirror leaves at most what the brightest does, so
 * all that can be added is bounded by a geometric sum.
 */
record FaintestWeight(double red, double green, double blue) {

    /**
     * What adds up to less changes no byte: a sum of 2^-11 or more stays what it is, as half of its last place is more; and
     * one below that is black with it and without, as the first byte above 0 begins at 1/510.
     */
    private static final double INVISIBLE = 0x1p-65;

    static FaintestWeight of(List<LightSource> lights, Material[] materials, double depth) {
        return new FaintestWeight(of(lights, materials, depth, Colour::red), of(lights, materials, depth, Colour::green),
                of(lights, materials, depth, Colour::blue));
    }

    private static double of(
            List<LightSource> lights, Material[] materials, double depth, ToDoubleFunction<Colour> component) {
        double light = 0, added = 0, mirror = 0;
        for (LightSource source : lights) {
            light += component.applyAsDouble(source.colour());
        }
        for (Material m : materials) {
            double specular = component.applyAsDouble(m.specular());
            // Of a negative shininess the highlight has no bound.
            double highlight = m.shininess() < 0 && light * specular > 0 ? Double.POSITIVE_INFINITY : light * specular;
            double diffuse = light * component.applyAsDouble(m.diffuse());
            added = Math.max(added, component.applyAsDouble(m.ambient()) + diffuse + highlight);
            mirror = Math.max(mirror, specular);
        }
        double sum = mirror < 1 ? 1 / (1 - mirror) : depth * Math.pow(mirror, depth);
        return added == 0 ? Double.POSITIVE_INFINITY : INVISIBLE / added / sum;
    }

    /** Whether a path of some weight may change what its sample has so far, which is cut at 1. */
    boolean canChange(double redWeight, double redSum, double greenWeight, double greenSum, double blueWeight,
            double blueSum) {
        return redWeight > red && redSum < 1 || greenWeight > green && greenSum < 1 || blueWeight > blue && blueSum < 1;
    }
}
