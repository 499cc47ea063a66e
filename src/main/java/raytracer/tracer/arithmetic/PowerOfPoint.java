package raytracer.tracer.arithmetic;

/**
 * The power of a point with respect to a sphere, |p - c|^2 - r^2: positive outside, negative inside, zero on it. Near a
 * huge sphere its terms cancel to almost nothing, so they are summed without error: each square and difference is
 * split into a rounded part and its exact rest (Dekker 1971; Knuth, TAOCP 4.2.2), and the parts are added like Ogita,
 * Rump and Oishi's Sum2 (Accurate Sum and Dot Product, 2005). The result is within u of the exact power plus 40 u^2
 * (|p - c|^2 + r^2).
 */
public final class PowerOfPoint {

    private PowerOfPoint() { }

    public static double of(double px, double py, double pz, double cx, double cy, double cz, double r) {
        double x = px - cx, y = py - cy, z = pz - cz;
        double xx = x * x, yy = y * y, zz = z * z, rr = r * r;
        double rest = Math.fma(x, x, -xx) + Math.fma(y, y, -yy) + Math.fma(z, z, -zz) - Math.fma(r, r, -rr)
                + 2 * (x * restOfSum(px, -cx, x) + y * restOfSum(py, -cy, y)
                        + z * restOfSum(pz, -cz, z));
        double s1 = xx + yy;
        double s2 = s1 + zz;
        double s3 = s2 - rr;
        rest += restOfSum(xx, yy, s1) + restOfSum(s1, zz, s2) + restOfSum(s2, -rr, s3);
        return s3 + rest;
    }

    /** What rounding took from a + b (Knuth's two-sum, for any order of magnitudes). */
    private static double restOfSum(double a, double b, double sum) {
        double bRounded = sum - a;
        return (a - (sum - bRounded)) + (b - bRounded);
    }
}
