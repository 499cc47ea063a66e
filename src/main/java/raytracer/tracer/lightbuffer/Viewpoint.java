package raytracer.tracer.lightbuffer;

import raytracer.tracer.rays.Lamp;

/**
 * From where a light buffer looks.
 *
 * @param source a light, or the eye in place of one
 * @param shown  what matters of what is seen; null if all does
 */
public record Viewpoint(Lamp source, Frustum shown) { }
