/**
 * A bounding volume hierarchy over numbered boxes: its nodes, how it is built by the surface area heuristic, and one
 * ray's walk through it. In: boxes. Out: the leaves that a ray may hit, nearest first. Must not know: what is in the
 * boxes.
 */
package raytracer.tracer.bvh;
