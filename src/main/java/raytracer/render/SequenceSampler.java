package raytracer.render;

import raytracer.tracer.PixelSink;
import raytracer.tracer.RayCounts;
import raytracer.tracer.Samples;
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

    SequenceSampler(TileTracer tracer, Sampling.Sequence sequence) {
        this.tracer = tracer;
        this.sequence = sequence;
    }

    @Override
    public void render(int left, int top, int columns, int rows, PixelSink sink) {
        PixelMeans means = new PixelMeans(columns * rows);
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            int x = left + pixel % columns, y = top + pixel / columns;
            int hash = (x * 0x9E3779B1 ^ y) * 0x85EBCA6B ^ sequence.seed();
            double shiftX = (hash >>> 16 & 0xFFFF) / 65536.0, shiftY = ((hash * 0xC2B2AE35) >>> 16 & 0xFFFF) / 65536.0;
            for (int k = 0; k < sequence.count(); k++) {
                samples.add(x + fraction(shiftX + k / PLASTIC), y + fraction(shiftY + k / (PLASTIC * PLASTIC)));
                means.expect(pixel);
                if (samples.isFull()) {
                    take(means);
                }
            }
        }
        take(means);
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            means.send(pixel, left + pixel % columns, top + pixel / columns, sink);
        }
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }

    private void take(PixelMeans means) {
        tracer.trace(samples);
        means.take(samples);
        samples.count = 0;
    }

    @Override
    public RayCounts counts() {
        return tracer.counts();
    }
}
