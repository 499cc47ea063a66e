package raytracer.tracer.rays;

/**
 * A rectangle of the picture, as the intervals in which the coordinates are of the vectors from the eye to its points.
 * Those have a length of 1 or more: so what is less far along a ray than some number, by its unit vector, is less far
 * by these too.
 */
public record Window(double[] least, double[] greatest) { }
