/**
 * What a scene is: immutable records. In: numbers that whoever makes them has validated. Out: the same, by name.
 * Must not know: where they come from, and what becomes of them.
 */
package raytracer.scene;
