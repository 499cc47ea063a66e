package raytracer.tracer.primitive;

import raytracer.scene.Material;

/**
 * What is known of every surface by its slot.
 *
 * @param declared its number in the order of declaration
 * @param look     which look it has; surfaces of one look are of one kind and one material
 * @param material by look
 */
public record SurfaceTable(int[] declared, int[] look, Material[] material) { }
