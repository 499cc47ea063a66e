/**
 * From text to scene. In: the bytes of a scene file. Out: a {@link raytracer.scene.Scene}, valid in every number,
 * or all of its mistakes with line and column; and what its author may not have meant. Must not know: how scenes
 * are traced, where files are, what is printed.
 */
package raytracer.parser;
