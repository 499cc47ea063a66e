package raytracer.tracer.settled;

import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Vectors;

/**
 * Tells where a highlight is so smooth in a cell that the mean of the cell's corners will do. It is (n . h)^s; with c
 * the chord from the normal to the half vector, about exp(-s c^2 / 2).
 */
final class Highlight {

    private final Vector[] chord = new Vector[Batch.CAPACITY];

    /** Sets the chord at a corner of the grid. */
    void set(int p, Vectors towardsLight, Vectors direction, Vectors normal) {
        Vector half = towardsLight.get(p).minus(direction.get(p)).unit();
        chord[p] = half.minus(normal.get(p));
    }

    /**
     * Whether the mean of a cell's corners is off by less than a tolerance: by the second derivative over 12 at most.
     *
     * @param corners of the cell
     */
    boolean isSmooth(int[] corners, Material material, Colour light, double tolerance) {
        double s = material.shininess(), change = 0, min = Double.POSITIVE_INFINITY, max = 0;
        for (int p : corners) {
            min = Math.min(min, chord[p].length());
            max = Math.max(max, chord[p].length());
            change = Math.max(change, chord[p].minus(chord[corners[0]]).length());
        }
        double nearest = Math.max(0, min - change / 2), farthest = max + change / 2;
        double peak = Math.exp(-s * nearest * nearest / 2);
        double bend = Math.min(1, s * Math.max(1, s * farthest * farthest) * change * change / 12);
        Colour specular = material.specular();
        double strength = Math.max(specular.red() * light.red(),
                Math.max(specular.green() * light.green(), specular.blue() * light.blue()));
        return Math.min(1, strength) * peak * bend <= tolerance;
    }
}
