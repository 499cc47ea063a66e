/**
 * Batches of rays as arrays, one a quantity: from the eye and from mirrors, and from points to a light; the samples
 * that they are traced for, and light sources. Data: must not know surfaces, nor how they are searched.
 */
package raytracer.tracer.rays;
