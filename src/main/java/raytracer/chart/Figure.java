package raytracer.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Panels in a grid under a heading, as an SVG file that is legible on white and on black. */
public final class Figure {

    private static final int HEAD = 44;
    private static final int FOOT = 40;
    private static final int MARGIN = 14;
    private static final int FONT_SIZE = 16;
    private static final int SMALL = 10;

    private static final String STYLE = """
            <style>
            text { font-family: Helvetica, Arial, sans-serif; font-size: 11px; fill: #222; stroke: none; }
            .heading { font-weight: bold; }
            .title { font-size: 12px; font-weight: bold; }
            .foot, .note { font-size: 10px; fill: #666; }
            .label { font-weight: bold; paint-order: stroke; }
            .frame { stroke: #555; fill: none; }
            .grid { stroke: #ddd; fill: none; }
            .band { fill: #2a9d4a; fill-opacity: .13; stroke: none; }
            .front { stroke: #888; fill: none; stroke-dasharray: 5 3; }
            .limit { stroke: #2a9d4a; fill: none; }
            .leader { stroke: #aaa; fill: none; stroke-width: .8; }
            .quartiles { stroke-width: 2; fill: none; }
            .s0 { fill: #c0392b; stroke: #c0392b; } .s1 { fill: #b9770e; stroke: #b9770e; }
            .s2 { fill: #2471a3; stroke: #2471a3; } .s3 { fill: #7d3c98; stroke: #7d3c98; }
            .s4 { fill: #1e8449; stroke: #1e8449; }
            text.label { stroke: #fff; stroke-width: 3px; }
            text.s0 { fill: #c0392b; } text.s1 { fill: #b9770e; } text.s2 { fill: #2471a3; }
            text.s3 { fill: #7d3c98; } text.s4 { fill: #1e8449; }
            .page { fill: #fff; }
            @media (prefers-color-scheme: dark) {
            .page { fill: #0d1117; }
            text { fill: #ddd; } text.label { stroke: #0d1117; } .foot, .note { fill: #999; }
            .grid { stroke: #333; } .frame { stroke: #999; }
            .s0 { fill: #ff7b6b; stroke: #ff7b6b; } .s1 { fill: #f0b44c; stroke: #f0b44c; }
            .s2 { fill: #5dade2; stroke: #5dade2; } .s3 { fill: #c39bd3; stroke: #c39bd3; }
            .s4 { fill: #58d68d; stroke: #58d68d; }
            text.s0 { fill: #ff7b6b; } text.s1 { fill: #f0b44c; } text.s2 { fill: #5dade2; }
            text.s3 { fill: #c39bd3; } text.s4 { fill: #58d68d; }
            }
            </style>
            """;

    private final String heading;
    private final String foot;
    private final int columns;
    private final int width;
    private final int height;
    private final List<Panel> panels = new ArrayList<>();
    private final StringBuilder legend = new StringBuilder();
    private double legendEnd = MARGIN;

    /** @param width and height of one panel */
    public Figure(String heading, String foot, int columns, int width, int height) {
        this.heading = heading;
        this.foot = foot;
        this.columns = columns;
        this.width = width;
        this.height = height;
    }

    public void add(Panel panel) {
        panels.add(panel);
    }

    /** Says what dots of a colour are. */
    public void explain(int series, String meaning) {
        mark("<circle class='s" + series + "' cx='%.0f' cy='-4' r='4'/>", meaning);
    }

    /** Says what the bars beside dots are. */
    public void explainBars(String meaning) {
        mark("<path class='quartiles s2' d='M%.0f -4 h12'/>", meaning);
    }

    /** Says what the dashed line is. */
    public void explainFront(String meaning) {
        mark("<path class='front' d='M%.0f -4 h12'/>", meaning);
    }

    private void mark(String symbol, String meaning) {
        legend.append(String.format(Locale.ROOT, symbol, legendEnd + 6)).append(String.format(Locale.ROOT,
                "<text class='note' x='%.0f' y='0'>%s</text>\n", legendEnd + 22, meaning));
        legendEnd += 36 + .6 * SMALL * meaning.length();
    }

    /** The text of the SVG file. */
    public String svg() {
        int rows = (panels.size() + columns - 1) / columns;
        int w = columns * width, h = HEAD + rows * height + FOOT;
        String size = "width='" + w + "' height='" + h + "'";
        StringBuilder svg = new StringBuilder("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + w + " " + h
                + "' " + size + ">\n" + STYLE + "<rect class='page' " + size + "/>\n"
                + line("heading", 27, FONT_SIZE, heading, w));
        for (int i = 0; i < panels.size(); i++) {
            svg.append("<g transform='translate(").append(i % columns * width).append(' ')
                    .append(HEAD + i / columns * height).append(")'>\n").append(panels.get(i).svg(width, height))
                    .append("</g>\n");
        }
        svg.append("<g transform='translate(0 ").append(h - 24).append(")'>\n").append(legend).append("</g>\n");
        return svg.append(line("foot", h - 8, SMALL, foot, w)).append("</svg>\n").toString();
    }

    /** A line across the figure, in so small a font that it fits. */
    private static String line(String style, int y, int fontSize, String text, int width) {
        int fitting = Math.min(fontSize, (int) ((width - 2 * MARGIN) / (Labels.WIDTH * text.length())));
        return String.format(Locale.ROOT, "<text class='%s' x='%d' y='%d' style='font-size:%dpx'>%s</text>\n", style, MARGIN,
                y, fitting, text);
    }
}
