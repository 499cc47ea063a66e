package raytracer.console;

/** Measures time from when it is made. */
public final class Stopwatch {

    private final long start = System.nanoTime();

    public double millis() {
        return (System.nanoTime() - start) / 1e6;
    }
}
