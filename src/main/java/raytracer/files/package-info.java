/**
 * Files that a run reads and writes: where a picture goes, so that none replaces what it should not; a file that is
 * whole or not there; the picture that another is compared with. Must not know: options, scenes, how pictures are
 * made.
 */
package raytracer.files;
