/**
 * Which surface a ray hits first, and whether any is in its way: for a whole batch by one beam, for each ray by its own
 * walk; and which of several wins that rounding cannot tell apart. Must not know: materials, shading.
 */
package raytracer.tracer.search;
