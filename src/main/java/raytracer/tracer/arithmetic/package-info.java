/**
 * Arithmetic on a batch's vectors, in loops that HotSpot makes vector instructions of, and bounds on rounding errors.
 * Must not know: rays, surfaces.
 */
package raytracer.tracer.arithmetic;
