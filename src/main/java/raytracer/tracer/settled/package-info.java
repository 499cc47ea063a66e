/**
 * What is proved of pixels while their corners are traced: that there is nothing in them but what the corners show, so
 * that they need no more samples. In: rays before and after each step. Out: which pixels are settled. Must not know:
 * what becomes of the others.
 */
package raytracer.tracer.settled;
