package raytracer.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * One log-log diagram: labelled points, curves, the Pareto front of the points (less is better on both axes), and a
 * band at the foot for results that cannot be told from none.
 */
public final class Panel {

    private static final int LEFT = 62;
    private static final int TOP = 34;
    private static final int BOTTOM = 46;
    private static final int RIGHT = 14;

    /** @param low and high the quartiles of x */
    private record Point(String label, int series, double x, double low, double high, double y) { }

    private record Line(double y, String label) { }

    private record Curve(String label, List<double[]> points) { }

    private final String title;
    private final String xLabel;
    private final String yLabel;
    private final double limit;
    private final String limitLabel;
    private final List<Point> points = new ArrayList<>();
    private final List<Curve> curves = new ArrayList<>();
    private final List<Line> lines = new ArrayList<>();
    private boolean besideX;
    private boolean front = true;

    /**
     * @param limit      the top of the band at the foot, at which zeros are drawn; 0 for no band and no zeros
     * @param limitLabel what the band says
     */
    public Panel(String title, String xLabel, String yLabel, double limit, String limitLabel) {
        this.title = title;
        this.xLabel = xLabel;
        this.yLabel = yLabel;
        this.limit = limit;
        this.limitLabel = limitLabel;
    }

    /** Gives the x axis a band of none as well. */
    public Panel withBandOnBothAxes() {
        besideX = true;
        return this;
    }

    /** Draws a line at a height, and what it means. */
    public void line(double y, String label) {
        lines.add(new Line(y, label));
    }

    /** Draws no Pareto front: for points that are not choices. */
    public Panel withoutFront() {
        front = false;
        return this;
    }

    public void point(String label, int series, double x, double low, double high, double y) {
        points.add(new Point(label, series, x, low, high, y));
    }

    public void curve(String label, List<double[]> line) {
        curves.add(new Curve(label, line));
    }

    /** The diagram as SVG elements in a box of this size. */
    String svg(int width, int height) {
        return new Drawing(width, height).draw();
    }

    private final class Drawing {
        private final int width;
        private final int height;
        private final double x0;
        private final double x1;
        private final double y0;
        private final double y1;
        private final StringBuilder out = new StringBuilder();
        private final List<double[]> taken = new ArrayList<>();

        Drawing(int width, int height) {
            this.width = width;
            this.height = height;
            double[] x = range(besideX ? limit : 0, true), y = range(limit, false);
            x0 = x[0];
            x1 = x[1];
            y0 = y[0];
            y1 = y[1];
        }

        /** Whole decades around the values; the band takes one more at the foot. */
        private double[] range(double band, boolean horizontal) {
            double low = Double.POSITIVE_INFINITY, high = Double.NEGATIVE_INFINITY;
            List<Double> values = new ArrayList<>();
            points.forEach(p -> values.add(horizontal ? p.x : p.y));
            curves.forEach(c -> c.points.forEach(p -> values.add(p[horizontal ? 0 : 1])));
            for (double v : values) {
                if (v > 0) {
                    low = Math.min(low, v);
                    high = Math.max(high, v);
                }
            }
            if (band > 0) {
                low = Math.min(low, band);
                high = Math.max(high, 10 * band);
            }
            double first = Math.floor(Math.log10(low) - .001), last = Math.ceil(Math.log10(high) + .05);
            double foot = band > 0 ? Math.min(first, Math.floor(Math.log10(band) - .3)) : first;
            return new double[] {foot, Math.max(last, first + 1)};
        }

        private double px(double x) {
            double v = besideX && x == 0 ? x0 + .25 : Math.log10(x);
            return LEFT + (v - x0) / (x1 - x0) * (width - LEFT - RIGHT);
        }

        private double py(double y) {
            double v = y == 0 ? y0 + .25 : Math.log10(y);
            return height - BOTTOM - (v - y0) / (y1 - y0) * (height - TOP - BOTTOM);
        }

        String draw() {
            text(LEFT, 18, "title", "start", title);
            axes();
            text((LEFT + width - RIGHT) / 2.0, height - 8, "axis", "middle", xLabel);
            line("<text class='axis' text-anchor='middle' transform='translate(13 %.1f) rotate(-90)'>%s</text>",
                    (TOP + height - BOTTOM) / 2.0, yLabel);
            lines.forEach(this::draw);
            curves.forEach(this::draw);
            if (front) {
                front();
            }
            points.forEach(this::draw);
            points.forEach(this::label);
            return out.toString();
        }

        private void axes() {
            if (limit > 0) {
                double top = py(limit);
                line("<rect class='band' x='%d' y='%.1f' width='%d' height='%.1f'/>", LEFT, top, width - LEFT - RIGHT,
                        height - BOTTOM - top);
                text(width - RIGHT - 4, top + 11, "note", "end", limitLabel);
                if (besideX) {
                    line("<rect class='band' x='%d' y='%d' width='%.1f' height='%d'/>", LEFT, TOP,
                            px(limit) - LEFT, height - TOP - BOTTOM);
                }
            }
            for (int e = (int) Math.ceil(x0); e < x1 + .001; e++) {
                double x = px(Math.pow(10, e));
                if (x0 < e) {
                    line("<path class='grid' d='M%.1f %d V%d'/>", x, TOP, height - BOTTOM);
                    text(x, height - BOTTOM + 14, "tick", "middle", power(e));
                }
                if (x1 - x0 <= 1 && e < x1) {
                    for (int step : new int[] {2, 5}) {
                        double value = step * Math.pow(10, e);
                        line("<path class='grid' d='M%.1f %d V%d'/>", px(value), TOP, height - BOTTOM);
                        text(px(value), height - BOTTOM + 14, "tick", "middle", number(value).replace(".0", ""));
                    }
                }
            }
            int step = y1 - y0 > 9 ? 2 : 1;
            for (int e = (int) Math.ceil(y0); e <= y1; e += step) {
                if (limit == 0 || y0 < e) {
                    double y = py(Math.pow(10, e));
                    line("<path class='grid' d='M%d %.1f H%d'/>", LEFT, y, width - RIGHT);
                    text(LEFT - 5, y + 4, "tick", "end", power(e));
                }
            }
            line("<path class='frame' d='M%d %d V%d H%d'/>", LEFT, TOP, height - BOTTOM, width - RIGHT);
        }

        private static String power(int e) {
            return e == 0 ? "1" : e == 1 ? "10" : e == 2 ? "100" : e == 3 ? "1000"
                    : "10<tspan dy='-5' font-size='8'>" + e + "</tspan>";
        }

        private void draw(Line at) {
            double y = py(at.y);
            line("<path class='front' d='M%d %.1f H%d'/>", LEFT, y, width - RIGHT);
            text(width - RIGHT - 4, y - 4, "note", "end", at.label);
        }

        private void draw(Curve curve) {
            StringBuilder path = new StringBuilder();
            for (double[] p : curve.points) {
                path.append(path.isEmpty() ? 'M' : 'L').append(number(px(p[0]))).append(' ').append(number(py(p[1])));
            }
            line("<path class='curve' d='%s'/>", path);
        }

        /** The points that no other beats on both axes, joined by steps. */
        private void front() {
            StringBuilder path = new StringBuilder();
            double best = Double.POSITIVE_INFINITY;
            List<Point> sorted = new ArrayList<>(points);
            sorted.sort((a, b) -> Double.compare(px(a.x), px(b.x)));
            for (Point p : sorted) {
                double y = py(p.y);
                if (path.isEmpty()) {
                    path.append("M").append(number(px(p.x))).append(' ').append(TOP).append('V').append(number(y));
                    best = y;
                } else if (y > best + .5) {
                    path.append('H').append(number(px(p.x))).append('V').append(number(y));
                    best = y;
                }
            }
            line("<path class='front' d='%sH%d'/>", path, width - RIGHT);
        }

        private void draw(Point p) {
            double x = px(p.x), y = py(p.y);
            if (p.high > p.low) {
                line("<path class='quartiles s%d' d='M%.1f %.1f H%.1f'/>", p.series, px(p.low), y, px(p.high));
            }
            line("<circle class='s%d' cx='%.1f' cy='%.1f' r='4.5'/>", p.series, x, y);
            taken.add(new double[] {x - 6, y - 6, x + 6, y + 6});
        }

        /** Beside its point, at the first of some places where it covers nothing. */
        private void label(Point p) {
            double x = px(p.x), y = py(p.y), length = 6.1 * p.label.length();
            double[][] places = {{8, 4}, {-8 - length, 4}, {-length / 2, -9}, {-length / 2, 17}, {8, -8}, {8, 15},
                {-8 - length, -8}, {-8 - length, 15}, {8, -20}, {8, 27}, {-8 - length, -20}, {-8 - length, 27}};
            for (double[] place : places) {
                double[] box = {x + place[0], y + place[1] - 9, x + place[0] + length, y + place[1] + 2};
                boolean free = box[0] > LEFT && box[2] < width && box[1] > TOP - 10 && box[3] < height - BOTTOM + 2
                        && taken.stream().allMatch(
                                t -> box[2] < t[0] || box[0] > t[2] || box[3] < t[1] || box[1] > t[3]);
                if (free) {
                    taken.add(box);
                    text(box[0], box[3] - 2, "label s" + p.series, "start", p.label);
                    return;
                }
            }
            text(Math.min(x + 8, width - length), y - 8, "label s" + p.series, "start", p.label);
        }

        private void text(double x, double y, String style, String anchor, String text) {
            line("<text class='%s' x='%.1f' y='%.1f' text-anchor='%s'>%s</text>", style, x, y, anchor, text);
        }

        private void line(String format, Object... values) {
            out.append(String.format(Locale.ROOT, format, values)).append('\n');
        }

        private static String number(double v) {
            return String.format(Locale.ROOT, "%.1f", v);
        }
    }
}
