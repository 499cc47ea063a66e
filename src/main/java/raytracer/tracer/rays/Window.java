package raytracer.tracer.rays;

/**
 * A rectangle of the picture, as bounds of the unnormalised directions from the eye to its points; they are at least 1
 * long, so a distance bounds their parameter too.
 */
public record Window(double[] min, double[] max) { }
