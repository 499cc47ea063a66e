/**
 * From linear colours to bytes to PNG. In: pixels, from many threads. Out: a file that is whole or not there; how
 * two pictures differ. Must not know: scenes, and how colours were found.
 */
package raytracer.image;
