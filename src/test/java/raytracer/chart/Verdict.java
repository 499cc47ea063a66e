package raytracer.chart;

import java.util.Arrays;

/**
 * How a method's answers compare with exact ones: distances, NaN where nothing is met.
 *
 * @param wrong  answers that miss what is met, meet what is not, or are off by more than a thousandth
 * @param p999   the 99.9th percentile of the relative error of the others' distances; NaN if hardly any has one
 */
record Verdict(int count, int wrong, double p999) {

    private static final double GROSS = 1e-3;

    /** Relative errors below half a unit roundoff show as that. */
    private static final double LEAST_ERROR = 0x1p-54;

    static Verdict of(double[] answers, double[] truth) {
        int wrong = 0, right = 0;
        double[] errors = new double[answers.length];
        for (int i = 0; i < answers.length; i++) {
            double error = Math.abs(answers[i] - truth[i]) / truth[i];
            if (Double.isNaN(answers[i]) != Double.isNaN(truth[i]) || error > GROSS) {
                wrong++;
            } else if (!Double.isNaN(error)) {
                errors[right++] = Math.max(error, LEAST_ERROR);
            }
        }
        Arrays.sort(errors, 0, right);
        return new Verdict(answers.length, wrong, right < answers.length / 100 ? Double.NaN : errors[(int) (.999 * (right - 1))]);
    }

    double wrongPerMillion() {
        return 1e6 * wrong / count;
    }
}
