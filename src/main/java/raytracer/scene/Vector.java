package raytracer.scene;

/**
 * A point or a displacement in world space.
 *
 * @param x finite
 * @param y finite
 * @param z finite
 */
public record Vector(double x, double y, double z) {

    public static final Vector ZERO = new Vector(0, 0, 0);

    public Vector minus(Vector other) {
        return new Vector(x - other.x, y - other.y, z - other.z);
    }

    public Vector times(double factor) {
        return new Vector(x * factor, y * factor, z * factor);
    }

    public double dot(Vector other) {
        return x * other.x + y * other.y + z * other.z;
    }

    public Vector cross(Vector other) {
        return new Vector(
                y * other.z - z * other.y,
                z * other.x - x * other.z,
                x * other.y - y * other.x);
    }

    /**
     * The vector of length 1 in this direction, each component within 3 ulp. The largest component is first brought
     * near 1 by a power of two, which is exact, so that no square overflows or underflows.
     *
     * @return a unit vector; all NaN if this vector is zero
     */
    public Vector unit() {
        int exponent = Math.getExponent(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))));
        double a = Math.scalb(x, -exponent), b = Math.scalb(y, -exponent), c = Math.scalb(z, -exponent);
        double length = Math.sqrt(a * a + b * b + c * c);
        return new Vector(a / length, b / length, c / length);
    }

    /** Coordinate 0, 1 or 2: x, y or z. */
    public double coordinate(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    public boolean isZero() {
        return x == 0 && y == 0 && z == 0;
    }

    /** |x| + |y| + |z| */
    public double l1Norm() {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    public double length() {
        return Math.sqrt(dot(this));
    }
}
