/**
 * The command line: puts the others together. In: arguments. Out: files, messages, an exit status. Only here is
 * anything printed, and only here does the program exit. Nothing may know this package.
 */
package raytracer.cli;
