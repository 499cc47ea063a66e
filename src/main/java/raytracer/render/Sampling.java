package raytracer.render;

/** How many samples pixels get. */
public sealed interface Sampling {

    /** Every pixel: one sample, in the middle. */
    Sampling CENTRES = new Grid(1);

    /** The greatest {@link Grid#n}. */
    int MAX = 64;

    /** @param n along a pixel's side, from 1 to {@link #MAX} */
    record Grid(int n) implements Sampling { }

    /**
     * Every pixel: a lattice of samples, in rows of no direction.
     *
     * @param count at least 1
     * @param seed  0, or what the lattices are shifted by: of different ones, errors are different
     */
    record Lattice(int count, int seed) implements Sampling { }

    /**
     * Every pixel: a lattice of as many samples as it takes.
     *
     * @param error the aim: the root of the mean square of the errors of all pixels' components, of a range of [0, 1]
     */
    record Within(double error) implements Sampling {

        /** The least error that can be aimed at. */
        public static final double MIN = 1e-4;

        /** One step of a picture's 256: no visible difference. */
        public static final double INVISIBLE = 1 / 255.0;
    }
}
