package raytracer.parser;

import raytracer.scene.Colour;
import raytracer.scene.Material;

/** The material commands in force: each shape takes the values that stand where it is declared. */
final class MaterialState {

    private Material current = Material.DEFAULT;

    /** The same object for as long as no value changes. */
    Material current() {
        return current;
    }

    void ambient(Colour c) {
        set(new Material(c, current.diffuse(), current.specular(), current.shininess()));
    }

    void diffuse(Colour c) {
        set(new Material(current.ambient(), c, current.specular(), current.shininess()));
    }

    void specular(Colour c) {
        set(new Material(current.ambient(), current.diffuse(), c, current.shininess()));
    }

    void shininess(double s) {
        set(new Material(current.ambient(), current.diffuse(), current.specular(), s));
    }

    private void set(Material material) {
        if (!material.equals(current)) {
            current = material;
        }
    }
}
