/**
 * What a user types and reads: options and their help, lines on a terminal, progress. Must not know: what is done with
 * them.
 */
package raytracer.console;
