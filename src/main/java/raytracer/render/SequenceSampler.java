package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.TileTracer;

/**
 * Every pixel is the mean of samples at points of the R2 sequence (Roberts, The Unreasonable Effectiveness of
 * Quasirandom Sequences, 2018), shifted differently in every pixel: as even as a grid, but in rows of no direction.
 */
final class SequenceSampler implements Sampler {

    /** The root of x^3 = x + 1, whose powers divide a square most evenly. */
    private static final double PLASTIC = 1.3247179572447460;

    private final TileTracer tracer;
    private final Sampling.Sequence sequence;
    private final Samples samples = Samples.ofColour();
    private final Points points = new Points();

    SequenceSampler(TileTracer tracer, Sampling.Sequence sequence) {
        this.tracer = tracer;
        this.sequence = sequence;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        PixelMeans means = new PixelMeans(columns * rows);
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            addSequence(pixel, left + pixel % columns, top + pixel / columns);
            // One at a time, as there may be very many samples a pixel.
            points.trace(tracer, samples, means);
        }
        means.send(left, top, columns, rows, sink);
    }

    private void addSequence(int pixel, int x, int y) {
        int hash = (x * 0x9E3779B1 ^ y) * 0x85EBCA6B ^ sequence.seed();
        double shiftX = (hash >>> 16) / 65536.0, shiftY = ((hash * 0xC2B2AE35) >>> 16) / 65536.0;
        for (int k = 0; k < sequence.count(); k++) {
            points.add(pixel, x + fraction(shiftX + k / PLASTIC), y + fraction(shiftY + k / (PLASTIC * PLASTIC)));
        }
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
