package raytracer.tracer.rays;

import java.util.concurrent.atomic.AtomicLong;

/** How many samples of a picture have been traced and how many are still to come; all threads of a tracer share it. */
public final class Progress {

    private final AtomicLong expected = new AtomicLong();
    private final AtomicLong done = new AtomicLong();

    /** So many more samples will be traced. */
    public void expect(long samples) {
        expected.addAndGet(samples);
    }

    public void add(long samples) {
        done.addAndGet(samples);
    }

    public long done() {
        return done.get();
    }

    /** What is still to be done of something, by how much of it has been done; 0 if nothing was expected. */
    public double ahead(double soFar) {
        return soFar * Math.max(0, expected.get() - done.get()) / Math.max(1, done.get());
    }
}
