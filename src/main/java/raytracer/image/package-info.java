/**
 * From linear colours to bytes to PNG. In: pixels, from many threads. Out: PNG to a stream, row by row as
 * rows are set; how two pictures differ. Must not know: scenes, and how colours were found.
 */
package raytracer.image;
