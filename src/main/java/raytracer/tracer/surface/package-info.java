/**
 * What a kind of surface must do for the tracer: intersect, block, move rays to their hits, alone and in batches; and
 * what a thread needs for it. Must not know: which kinds there are.
 */
package raytracer.tracer.surface;
