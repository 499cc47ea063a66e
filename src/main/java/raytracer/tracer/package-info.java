/**
 * From points of the picture to colours: the algorithm itself. In: a {@link raytracer.scene.Scene}, compiled once into
 * surfaces by kind and trees ({@link raytracer.tracer.Tracer}), and samples. Out: a linear colour for each, not cut to a
 * range. {@link raytracer.tracer.TileTracer} is where to start reading: find the closest hits, move there, shade,
 * reflect. Its wings know only those before them: arithmetic, bvh, rays, surface, primitive and search.
 * Must not know: the parser, pixels as bytes, threads, and whoever waits for it.
 */
package raytracer.tracer;
