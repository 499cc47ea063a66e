package raytracer.exact;

/**
 * A number of about 104 bits: the unevaluated sum of two doubles (Dekker, A floating-point technique for extending the
 * available precision, 1971; the accurate sum and product of Joldes, Muller and Popescu, Tight and rigorous error bounds
 * for basic building blocks of double-word arithmetic, 2017). Every operation rounds by at most 2^-100.
 */
public record Exact(double high, double low) implements Comparable<Exact> {

    public static final Exact ZERO = of(0);
    public static final Exact ONE = of(1);

    public static Exact of(double x) {
        return new Exact(x, 0);
    }

    private static Exact twoSum(double a, double b) {
        double s = a + b;
        double bRounded = s - a;
        return new Exact(s, (a - (s - bRounded)) + (b - bRounded));
    }

    private static Exact fastTwoSum(double a, double b) {
        double s = a + b;
        return new Exact(s, b - (s - a));
    }

    public Exact plus(Exact other) {
        Exact s = twoSum(high, other.high);
        Exact t = twoSum(low, other.low);
        Exact v = fastTwoSum(s.high, s.low + t.high);
        return fastTwoSum(v.high, t.low + v.low);
    }

    public Exact minus(Exact other) {
        return plus(other.negated());
    }

    public Exact negated() {
        return new Exact(-high, -low);
    }

    public Exact times(Exact other) {
        double product = high * other.high;
        double rest = Math.fma(high, other.high, -product);
        return fastTwoSum(product, rest + Math.fma(high, other.low, low * other.high));
    }

    public Exact times(double factor) {
        return times(of(factor));
    }

    /** Long division: each digit takes 53 bits off the rest. */
    public Exact over(Exact other) {
        double first = high / other.high;
        Exact rest = minus(other.times(first));
        double second = rest.high / other.high;
        double third = rest.minus(other.times(second)).high / other.high;
        Exact sum = fastTwoSum(first, second);
        return fastTwoSum(sum.high, sum.low + third);
    }

    /** One step of Newton's from the double's root doubles its bits. */
    public Exact root() {
        if (high <= 0) {
            return ZERO;
        }
        Exact first = of(Math.sqrt(high));
        return first.plus(minus(first.times(first)).over(first.times(2)));
    }

    public Exact abs() {
        return high < 0 ? negated() : this;
    }

    public int sign() {
        return high != 0 ? (int) Math.signum(high) : (int) Math.signum(low);
    }

    @Override
    public int compareTo(Exact other) {
        return minus(other).sign();
    }

    public boolean isMore(Exact other) {
        return compareTo(other) > 0;
    }

    /** Tangent of an angle in radians between 0 and pi/2, by the series of sine and cosine of a sixteenth of it. */
    public Exact tangent() {
        Exact x = times(1 / 16.0);
        Exact sine = x, cosine = ONE, term = ONE;
        for (int k = 1; k < 30; k++) {
            term = term.times(x).over(of(k));
            if (k % 2 == 0) {
                cosine = cosine.plus((k / 2) % 2 == 1 ? term.negated() : term);
            } else if (k > 1) {
                sine = sine.plus((k / 2) % 2 == 1 ? term.negated() : term);
            }
        }
        Exact t = sine.over(cosine);
        for (int i = 0; i < 4; i++) {
            t = t.times(2).over(ONE.minus(t.times(t)));
        }
        return t;
    }

    /**
     * A power. Whole exponents up to 10,000 are multiplied out; others take the library's double power, corrected for
     * the low part, which is good to 2^-52 of the result.
     */
    public Exact power(double exponent) {
        if (exponent == Math.rint(exponent) && exponent >= 0 && exponent <= 10_000) {
            Exact result = ONE, factor = this;
            for (int n = (int) exponent; n > 0; n >>= 1) {
                result = (n & 1) == 1 ? result.times(factor) : result;
                factor = factor.times(factor);
            }
            return result;
        }
        double power = Math.pow(high, exponent);
        return high == 0 || Double.isInfinite(power) ? of(power) : of(power).times(ONE.plus(of(exponent * low / high)));
    }
}
