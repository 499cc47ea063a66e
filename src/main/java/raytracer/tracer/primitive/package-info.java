/**
 * Planes, spheres and triangles: at what distance a ray hits one, whether one is between a point and a light, and where
 * a ray that hits it arrives, each with bounds on its error. A mesh's triangles, of which there may be millions, lie in flat
 * arrays. Must not know: how candidates are found.
 */
package raytracer.tracer.primitive;
