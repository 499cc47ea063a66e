package raytracer.tracer;

import raytracer.scene.Material;

/**
 * What is known of every surface by its slot.
 *
 * @param declared its number in the order of declaration
 * @param material what it is made of
 */
record SlotTable(int[] declared, Material[] material) {

    SlotTable(int count) {
        this(new int[count], new Material[count]);
    }
}
