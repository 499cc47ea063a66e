package raytracer.render;

import raytracer.tracer.TileTracer;
import raytracer.tracer.rays.Samples;

/** Samples of a tile's pixels, one pixel's after the other's, which are traced as soon as they make a batch. */
final class SampleQueue {

    private final TileTracer tracer;
    private final boolean withSquares;
    private final Samples samples = new Samples();
    private PixelMeans means;

    // By run of samples of one pixel, which it is and where they end.
    private final int[] pixel = new int[Samples.CAPACITY];
    private final int[] end = new int[Samples.CAPACITY];
    private int runs;

    /** @param withSquares whether it matters how much the samples of a pixel differ */
    SampleQueue(TileTracer tracer, boolean withSquares) {
        this.tracer = tracer;
        this.withSquares = withSquares;
    }

    /** From now on, samples are of these pixels; there must be none in the queue. */
    void start(PixelMeans newMeans) {
        means = newMeans;
    }

    /** Adds a pixel's samples. @param ofPixel its number among the pixels */
    void add(int ofPixel, Pattern pattern, int column, int row) {
        for (int from = 0; from < pattern.count(); ) {
            int number = Math.min(pattern.count() - from, Samples.CAPACITY - samples.count());
            pattern.add(samples, from, number, column, row);
            pixel[runs] = ofPixel;
            end[runs++] = samples.count();
            from += number;
            if (samples.count() == Samples.CAPACITY) {
                flush();
            }
        }
    }

    /** Traces what is still in the queue, and adds the colours to the means of their pixels. */
    void flush() {
        tracer.trace(samples);
        PixelMeans.cut(samples);
        for (int run = 0, from = 0; run < runs; from = end[run++]) {
            means.add(samples, from, end[run], pixel[run]);
            if (withSquares) {
                means.addSquares(samples, from, end[run], pixel[run]);
            }
        }
        samples.clear();
        runs = 0;
    }
}
