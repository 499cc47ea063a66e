package raytracer.render;

import raytracer.tracer.rays.Samples;

/**
 * Where in a pixel its samples are. A grid is that of the picture n times as large, whose pixels they are. A lattice is a
 * rank-1 lattice: as even as a grid, but in rows of no direction, so that no fence is in step with them (Dammertz and Keller,
 * Image Synthesis by Rank-1 Lattices, 2008; by the golden ratio, which is good for most numbers of samples). Its middle is
 * the pixel's, so that errors on both sides of a straight edge cancel.
 */
final class Pattern {

    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    private final int count;
    private final int width;
    private final int seed;

    /** Of a lattice: from one of so many rows' samples to the next. */
    private final double step;

    // By sample. A lattice is mirrored in half of the pixels, and its axes are exchanged in half: what is in step with one is
    // not with all.
    private final double[] even;
    private final double[] other;
    private final double[] mirrored;

    private Pattern(int count, int width, int seed, double step) {
        this.count = count;
        this.width = width;
        this.seed = seed;
        this.step = step;
        even = new double[count];
        other = new double[count];
        mirrored = new double[count];
    }

    /** @param n samples along a pixel's side */
    static Pattern grid(int n) {
        Pattern grid = new Pattern(n * n, n, 0, 0);
        for (int i = 0; i < n * n; i++) {
            grid.even[i] = i % n + 0.5;
            grid.other[i] = i / n + 0.5;
        }
        return grid;
    }

    /** @param seed 0, or the lattice is shifted at random, by seed and pixel */
    static Pattern lattice(int count, int seed) {
        Pattern lattice = new Pattern(count, 1, seed, step(count));
        lattice.setLattice(0, 0);
        return lattice;
    }

    private void setLattice(double shiftX, double shiftY) {
        for (int k = 0; k < count; k++) {
            double row = (k - (count - 1) / 2.0) * step;
            even[k] = fraction(shiftX + (k + 0.5) / count);
            other[k] = fraction(shiftY + 0.5 + row);
            mirrored[k] = fraction(shiftY + 0.5 - row);
        }
    }

    /** How many samples a pixel gets. */
    int count() {
        return count;
    }

    /** How many samples wide a pixel is, in the picture that is traced. */
    int width() {
        return width;
    }

    /** Adds some samples of a pixel. */
    void add(Samples samples, int from, int number, int column, int row) {
        if (step == 0) {
            samples.add(even, other, from, number, (double) width * column, (double) width * row, width);
            return;
        }
        int hash = (column * 0x9E3779B1 ^ row) * 0x85EBCA6B ^ seed;
        if (seed != 0) {
            setLattice((hash >>> 16) / 65536.0, ((hash * 0xC2B2AE35) >>> 16) / 65536.0);
        }
        double[] second = (hash >> 20 & 1) == 0 ? other : mirrored;
        boolean isExchanged = (hash >> 21 & 1) == 0;
        samples.add(isExchanged ? second : even, isExchanged ? even : second, from, number, column, row, 1);
    }

    /**
     * How far it is from one of so many rows' samples to that of the next: for some numbers not by the golden ratio. On
     * random edges that is off by .69 to .79 times v^1/2 N^-3/4, but by .79 to .88 for these, of which all steps were
     * tried, and which are off by .71 to .73 so.
     */
    private static double step(int number) {
        return switch (number) {
            case 6 -> .432;
            case 9 -> .302;
            case 10 -> .388;
            case 11 -> .416;
            case 15 -> .41;
            case 22 -> .38;
            case 24 -> .296;
            case 28 -> .29;
            case 39 -> .378;
            case 40 -> .422;
            default -> GOLDEN;
        };
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }
}
