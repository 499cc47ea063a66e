package raytracer.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * One log-log diagram: labelled points, their Pareto front (less is better on both axes: none on it is beaten on both),
 * and a band at the foot for results that cannot be told from none.
 */
public final class Panel {

    private static final int LEFT = 62;
    private static final int TOP = 34;
    private static final int BOTTOM = 46;
    private static final int RIGHT = 22;

    /** Ticks of the x and y axis that are nearer to one another than this are not both named. */
    private static final int TICK_WIDTH = 34;
    private static final int TICK_HEIGHT = 13;

    /** A note's font and the distance to the next one. */
    private static final int SMALL = 10;
    private static final int LINE = 12;

    /** @param low and high the quartiles of x */
    private record Point(String label, int series, double x, double low, double high, double y) { }

    private record Line(double y, String label) { }

    private final String title;
    private final String xLabel;
    private final String yLabel;
    private final double limit;
    private final String limitLabel;
    private final List<Point> points = new ArrayList<>();
    private final List<Line> lines = new ArrayList<>();

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

    /** Draws a line at a height, and what it means. */
    public void line(double y, String label) {
        lines.add(new Line(y, label));
    }

    public void point(String label, int series, double x, double low, double high, double y) {
        points.add(new Point(label, series, x, low, high, y));
    }

    /** The diagram as SVG elements in a box of this size. */
    String svg(int width, int height) {
        return new Drawing(width, height).draw();
    }

    private final class Drawing {
        private final int width;
        private final int height;
        private final Axis xAxis;
        private final Axis yAxis;
        private final Labels labels;
        private final StringBuilder out = new StringBuilder();

        Drawing(int width, int height) {
            this.width = width;
            this.height = height;
            xAxis = Axis.around(points.stream().flatMap(p -> Stream.of(p.low, p.x, p.high)).toList(), 0);
            yAxis = Axis.around(Stream.concat(points.stream().map(Point::y), lines.stream().map(Line::y)).toList(), limit);
            labels = new Labels(new Labels.Box(LEFT + 2, TOP, width - 2, height - BOTTOM - 2));
        }

        private double px(double x) {
            return LEFT + xAxis.at(x) * (width - LEFT - RIGHT);
        }

        private double py(double y) {
            return height - BOTTOM - yAxis.at(y) * (height - TOP - BOTTOM);
        }

        String draw() {
            text(LEFT, 18, "title", "start", title);
            if (limit > 0) {
                double top = py(limit);
                line("<rect class='band' x='%d' y='%.1f' width='%d' height='%.1f'/>", LEFT, top, width - LEFT - RIGHT,
                        height - BOTTOM - top);
            }
            ticks();
            text((LEFT + width - RIGHT) / 2.0, height - 8, "axis", "middle", xLabel);
            line("<text class='axis' text-anchor='middle' transform='translate(13 %.1f) rotate(-90)'>%s</text>",
                    (TOP + height - BOTTOM) / 2.0, yLabel);
            front();
            points.forEach(this::draw);
            lines.forEach(this::draw);
            if (limit > 0) {
                note(limitLabel, py(limit) + 11);
            }
            points.forEach(this::label);
            return out.toString();
        }

        private void ticks() {
            List<Double> named = new ArrayList<>();
            for (double tick : xAxis.ticks()) {
                line("<path class='grid' d='M%.1f %d V%d'/>", px(tick), TOP, height - BOTTOM);
                if (isApart(named, px(tick), TICK_WIDTH)) {
                    text(px(tick), height - BOTTOM + 14, "tick", "middle", Axis.name(tick));
                }
            }
            named.clear();
            for (double tick : yAxis.ticks()) {
                line("<path class='grid' d='M%d %.1f H%d'/>", LEFT, py(tick), width - RIGHT);
                if (isApart(named, py(tick), TICK_HEIGHT)) {
                    text(LEFT - 5, py(tick) + 4, "tick", "end", Axis.name(tick));
                }
            }
            line("<path class='frame' d='M%d %d V%d H%d'/>", LEFT, TOP, height - BOTTOM, width - RIGHT);
        }

        /** Whether a tick is far enough from those that are named, of which it then is one. */
        private static boolean isApart(List<Double> named, double at, int distance) {
            return named.stream().allMatch(other -> Math.abs(other - at) >= distance) && named.add(at);
        }

        private void draw(Line at) {
            double y = py(at.y);
            line("<path class='limit' d='M%d %.1f H%d'/>", LEFT, y, width - RIGHT);
            note(at.label, y - 4);
        }

        /** At the right end, or the left one if something is there; or one of those farther down. */
        private void note(String note, double baseline) {
            double length = Labels.WIDTH * SMALL * note.length();
            for (double y = baseline; y < height - BOTTOM; y += LINE) {
                for (double x : new double[] {width - RIGHT - 4 - length, LEFT + 4}) {
                    if (labels.takeIfFree(Labels.Box.of(x, y, note.length(), SMALL))) {
                        text(x, y, "note", "start", note);
                        return;
                    }
                }
            }
        }

        /** The points that no other beats on both axes, joined by steps; it ends at the best. */
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
            line("<path class='front' d='%s'/>", path);
        }

        private void draw(Point p) {
            double x = px(p.x), y = py(p.y);
            if (p.high > p.low) {
                line("<path class='quartiles s%d' d='M%.1f %.1f H%.1f'/>", p.series, px(p.low), y, px(p.high));
                labels.take(new Labels.Box(px(p.low), y - 2, px(p.high), y + 2));
            }
            line("<circle class='s%d' cx='%.1f' cy='%.1f' r='4.5'/>", p.series, x, y);
            labels.take(new Labels.Box(x - 6, y - 6, x + 6, y + 6));
        }

        private void label(Point p) {
            double x = px(p.x), y = py(p.y);
            Labels.Box box = labels.place(x, y, p.label.length());
            double nearX = Math.max(box.left(), Math.min(box.right(), x));
            double nearY = Math.max(box.top(), Math.min(box.bottom(), y));
            if (Math.hypot(nearX - x, nearY - y) > 14) {
                line("<path class='leader' d='M%.1f %.1f L%.1f %.1f'/>", x, y, nearX, nearY);
            }
            text(box.left(), box.bottom() - 3, "label s" + p.series, "start", p.label);
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
