/**
 * From linear colours to bytes to PNG. In: pixels, from many threads. Out: PNG to a stream; how two pictures differ.
 * Must not know: scenes, and how colours were found.
 */
package raytracer.image;
