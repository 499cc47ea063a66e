/**
 * From points of the picture to colours. In: a {@link raytracer.scene.Scene}, compiled once into flat arrays and
 * trees ({@link raytracer.tracer.Tracer}), and {@link raytracer.tracer.Samples}. Out: a linear colour for each,
 * not cut to a range. Must not know: text, pixels as bytes, threads (but for building trees), and whoever waits
 * for it.
 */
package raytracer.tracer;
