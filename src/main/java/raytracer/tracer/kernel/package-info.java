/**
 * Arithmetic on arrays of numbers and vectors, and bounds on its rounding errors. The code here is shaped for
 * HotSpot: a {@link raytracer.tracer.kernel.Kernel} is a small loop over arrays that C2 turns into vector instructions,
 * and it is run by way of a call that hides its kind, so that each is compiled once and not again in every caller. Must
 * not know: rays, surfaces.
 */
package raytracer.tracer.kernel;
