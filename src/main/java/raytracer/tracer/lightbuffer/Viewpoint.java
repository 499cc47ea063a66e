package raytracer.tracer.lightbuffer;

import raytracer.tracer.rays.LightSource;

/**
 * From where a light buffer looks.
 *
 * @param source a light, or the eye in place of one
 * @param shown  what matters of what is seen; null if all does
 */
public record Viewpoint(LightSource source, Frustum shown) { }
