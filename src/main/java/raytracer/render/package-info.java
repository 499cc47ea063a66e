/**
 * From a region of the picture to its pixels. In: a {@link raytracer.tracer.Tracer}, how many samples pixels get,
 * how many threads. Out: pixels, in no certain order, to a {@link raytracer.tracer.PixelSink}, the same for any
 * number of threads. Must not know: what becomes of the pixels; files and encodings.
 */
package raytracer.render;
