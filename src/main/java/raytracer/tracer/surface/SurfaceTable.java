package raytracer.tracer.surface;

import raytracer.scene.Material;

/**
 * What is known of every surface by its index.
 *
 * @param declared      its number in the order of declaration
 * @param materialIndex which of the materials it has; surfaces of different kinds never share one
 */
public record SurfaceTable(int[] declared, int[] materialIndex, Material[] materials) { }
