package raytracer.tracer;

/** How many rays were traced. */
public record RayCounts(long primary, long shadow, long reflection) {

    public static final RayCounts ZERO = new RayCounts(0, 0, 0);

    public RayCounts plus(RayCounts other) {
        return new RayCounts(primary + other.primary, shadow + other.shadow, reflection + other.reflection);
    }

    public long total() {
        return primary + shadow + reflection;
    }
}
