package raytracer.image;

import raytracer.tracer.PixelSink;

/** A picture of colours that are cut to [0, 1] but not rounded: to measure errors that are less than a step of 256. */
public record Canvas(int width, float[] values) implements PixelSink {

    private static final int COMPONENTS = 3;

    public Canvas(int width, int height) {
        this(width, new float[Math.multiplyExact(COMPONENTS, Math.multiplyExact(width, height))]);
    }

    @Override
    public void setPixels(int x, int y, int columns, int rows, double[] red, double[] green, double[] blue) {
        for (int i = 0; i < columns * rows; i++) {
            int at = COMPONENTS * ((y + i / columns) * width + x + i % columns);
            values[at] = cut(red[i]);
            values[at + 1] = cut(green[i]);
            values[at + 2] = cut(blue[i]);
        }
    }

    private static float cut(double c) {
        return c > 0 ? c < 1 ? (float) c : 1 : 0;
    }

    /** The root of the mean square of the difference from a picture of the same size. */
    public double rmse(Canvas other) {
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
            double d = values[i] - (double) other.values[i];
            sum += d * d;
        }
        return Math.sqrt(sum / values.length);
    }

    /** The greatest difference of a component from a picture of the same size. */
    public double maxDifference(Canvas other) {
        double max = 0;
        for (int i = 0; i < values.length; i++) {
            max = Math.max(max, Math.abs(values[i] - (double) other.values[i]));
        }
        return max;
    }

    /** The mean of two pictures of the same size. */
    public static Canvas mean(Canvas a, Canvas b) {
        Canvas mean = new Canvas(a.width, a.values.length / COMPONENTS / a.width);
        for (int i = 0; i < mean.values.length; i++) {
            mean.values[i] = (a.values[i] + b.values[i]) / 2;
        }
        return mean;
    }
}
