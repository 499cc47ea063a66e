package raytracer.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/**
 * One log-log diagram: numbered points, their Pareto front (less is better on both axes: none on it is beaten on both),
 * and a band at the foot for results that cannot be told from none.
 */
public final class Panel {

    private static final int LEFT = 62;
    private static final int TOP = 34;
    private static final int BOTTOM = 46;
    private static final int RIGHT = 22;

    /** Between the frame and the nearest points: room for their dots. */
    private static final int INSET = 12;

    /** From one dot to the next where several would lie on one another. */
    private static final int APART = 17;

    /** Ticks of the x and y axis that are nearer to one another than this are not both named. */
    private static final int TICK_WIDTH = 34;
    private static final int TICK_HEIGHT = 13;

    /** @param low and high the ends of the bar along x */
    private record Point(String name, int series, double x, double low, double high, double y) { }

    private final String title;
    private final String xLabel;
    private final String yLabel;
    private final double band;
    private final List<Point> points = new ArrayList<>();
    private final List<Double> limits = new ArrayList<>();

    /** @param band the top of the band at the foot, in which zeros are drawn; 0 for no band and no zeros */
    public Panel(String title, String xLabel, String yLabel, double band) {
        this.title = title;
        this.xLabel = xLabel;
        this.yLabel = yLabel;
        this.band = band;
    }

    /** Draws a line at a height. */
    public void limit(double y) {
        limits.add(y);
    }

    public void point(String name, int series, double x, double low, double high, double y) {
        points.add(new Point(name, series, x, low, high, y));
    }

    /** Adds the names of all points, each with its series. */
    void names(Map<String, Integer> seriesOf) {
        points.forEach(p -> seriesOf.putIfAbsent(p.name, p.series));
    }

    /** The diagram as SVG elements in a box of this size; a point's number is its name's place, from 1. */
    String svg(int width, int height, List<String> names) {
        return new Drawing(width, height, names).draw();
    }

    private final class Drawing {
        private final int width;
        private final int height;
        private final List<String> names;
        private final Axis xAxis;
        private final Axis yAxis;
        private final List<double[]> dots = new ArrayList<>();
        private final StringBuilder out = new StringBuilder();

        /** Over all bars and lines, so that none strikes a number through. */
        private final StringBuilder discs = new StringBuilder();

        Drawing(int width, int height, List<String> names) {
            this.width = width;
            this.height = height;
            this.names = names;
            xAxis = Axis.around(points.stream().flatMap(p -> Stream.of(p.low, p.x, p.high)).toList(), 0);
            yAxis = Axis.around(Stream.concat(points.stream().map(Point::y), limits.stream()).toList(), band);
        }

        private double px(double x) {
            return LEFT + INSET + xAxis.at(x) * (width - LEFT - RIGHT - 2 * INSET);
        }

        private double py(double y) {
            return height - BOTTOM - INSET - yAxis.at(y) * (height - TOP - BOTTOM - 2 * INSET);
        }

        String draw() {
            text(LEFT, 18, "title", "start", title);
            if (band > 0) {
                line("<rect class='band' x='%d' y='%.1f' width='%d' height='%.1f'/>", LEFT, py(band), width - LEFT - RIGHT,
                        height - BOTTOM - py(band));
            }
            ticks();
            text((LEFT + width - RIGHT) / 2.0, height - 8, "axis", "middle", xLabel);
            line("<text class='axis' text-anchor='middle' transform='translate(13 %.1f) rotate(-90)'>%s</text>",
                    (TOP + height - BOTTOM) / 2.0, yLabel);
            front();
            limits.forEach(y -> line("<path class='limit' d='M%d %.1f H%d'/>", LEFT, py(y), width - RIGHT));
            points.forEach(this::draw);
            return out.append(discs).toString();
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

        /** A dot with its number. Where others are, it is the nearest free place, at the end of a line from the point. */
        private void draw(Point p) {
            double x = px(p.x), y = py(p.y), atX = x, atY = y;
            for (int step = 1; !isFree(atX, atY); step++) {
                double way = APART * (1 + step / 8), angle = Math.PI / 4 * (step % 8);
                atX = x + way * Math.sin(angle);
                atY = y - way * Math.cos(angle);
            }
            dots.add(new double[] {atX, atY});
            if (p.high > p.low) {
                line("<path class='bar s%d' d='M%.1f %.1f H%.1f'/>", p.series, px(p.low), y, px(p.high));
            }
            if (atX != x || atY != y) {
                line("<path class='s%d' d='M%.1f %.1f L%.1f %.1f'/>", p.series, x, y, atX, atY);
            }
            discs.append(Figure.disc(atX, atY, p.series, names.indexOf(p.name) + 1));
        }

        private boolean isFree(double x, double y) {
            return x >= LEFT && x <= width - RIGHT && y >= TOP && y <= height - BOTTOM
                    && dots.stream().allMatch(dot -> Math.hypot(dot[0] - x, dot[1] - y) >= APART - 1);
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
