package raytracer.chart;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Panels in a grid under a heading, and beside them a key to the numbers of their dots, as an SVG file that is legible on
 * white and on black.
 */
public final class Figure {

    private static final int HEAD = 44;
    private static final int FOOT = 24;
    private static final int MARGIN = 14;
    private static final int FONT_SIZE = 16;
    private static final int SMALL = 10;

    /** Of bold characters, for each pixel of the font's size: a little more than most fonts have. */
    static final double CHARACTER_WIDTH = .63;

    /** From one line of the key to the next, and from its left side to its words. */
    private static final int KEY_LINE = 16;
    private static final int KEY_INDENT = 20;

    private static final String STYLE = """
            <style>
            text { font-family: Helvetica, Arial, sans-serif; font-size: 11px; fill: #222; stroke: none; }
            .heading { font-weight: bold; }
            .title { font-size: 12px; font-weight: bold; }
            .foot { font-size: 10px; fill: #666; }
            text.number { font-size: 9px; font-weight: bold; fill: #fff; }
            .frame { stroke: #555; fill: none; }
            .grid { stroke: #ddd; fill: none; }
            .band { fill: #2a9d4a; fill-opacity: .13; stroke: none; }
            .front { stroke: #888; fill: none; stroke-dasharray: 5 3; }
            .limit { stroke: #2a9d4a; fill: none; }
            .bar { stroke-width: 2; fill: none; }
            .s0 { fill: #c0392b; stroke: #c0392b; } .s1 { fill: #9a6209; stroke: #9a6209; }
            .s2 { fill: #2471a3; stroke: #2471a3; } .s3 { fill: #7d3c98; stroke: #7d3c98; }
            .s4 { fill: #1e8449; stroke: #1e8449; }
            .page { fill: #fff; }
            @media (prefers-color-scheme: dark) {
            .page { fill: #0d1117; }
            text { fill: #ddd; } .foot { fill: #999; } text.number { fill: #0d1117; }
            .grid { stroke: #333; } .frame { stroke: #999; }
            .s0 { fill: #ff7b6b; stroke: #ff7b6b; } .s1 { fill: #f0b44c; stroke: #f0b44c; }
            .s2 { fill: #5dade2; stroke: #5dade2; } .s3 { fill: #c39bd3; stroke: #c39bd3; }
            .s4 { fill: #58d68d; stroke: #58d68d; }
            }
            </style>
            """;

    private final String heading;
    private final String foot;
    private final int columns;
    private final int width;
    private final int height;
    private final List<Panel> panels = new ArrayList<>();

    /** What is in the key below the numbers: by its meaning a symbol, 12 wide and around a height of 0. */
    private final Map<String, String> symbols = new LinkedHashMap<>();

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
        symbols.put(meaning, "<circle class='s" + series + "' cx='6' cy='0' r='4'/>");
    }

    /** Says what the bars beside dots are. */
    public void explainBars(String meaning) {
        symbols.put(meaning, "<path class='bar s2' d='M0 0 h12'/>");
    }

    /** Says what the dashed line is. */
    public void explainFront(String meaning) {
        symbols.put(meaning, "<path class='front' d='M0 0 h12'/>");
    }

    /** Says what the line across a panel is. */
    public void explainLimit(String meaning) {
        symbols.put(meaning, "<path class='limit' d='M0 0 h12'/>");
    }

    /** Says what the band at the foot of a panel is. */
    public void explainBand(String meaning) {
        symbols.put(meaning, "<rect class='band' x='0' y='-5' width='12' height='10'/>");
    }

    /** The text of the SVG file. */
    public String svg() {
        Map<String, Integer> seriesOf = new LinkedHashMap<>();
        panels.forEach(panel -> panel.names(seriesOf));
        List<String> names = List.copyOf(seriesOf.keySet());
        int rows = (panels.size() + columns - 1) / columns;
        StringBuilder key = new StringBuilder();
        int lines = 0;
        for (String name : names) {
            key.append(line(lines++, disc(6, 0, seriesOf.get(name), names.indexOf(name) + 1), name));
        }
        lines++;
        for (Map.Entry<String, String> symbol : symbols.entrySet()) {
            key.append(line(lines++, symbol.getValue(), symbol.getKey()));
        }
        int longest = Math.max(names.stream().mapToInt(String::length).max().orElse(0),
                symbols.keySet().stream().mapToInt(String::length).max().orElse(0));
        int w = columns * width + KEY_INDENT + MARGIN + (int) (CHARACTER_WIDTH * 11 * longest);
        int h = HEAD + Math.max(rows * height, (lines + 2) * KEY_LINE) + FOOT;
        String size = "width='" + w + "' height='" + h + "'";
        StringBuilder svg = new StringBuilder("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + w + " " + h
                + "' " + size + ">\n" + STYLE + "<rect class='page' " + size + "/>\n"
                + across("heading", 27, FONT_SIZE, heading, w));
        for (int i = 0; i < panels.size(); i++) {
            svg.append(moved(i % columns * width, HEAD + i / columns * height, panels.get(i).svg(width, height, names)));
        }
        svg.append(moved(columns * width, HEAD + 2 * KEY_LINE, key.toString()));
        return svg.append(across("foot", h - 8, SMALL, foot, w)).append("</svg>\n").toString();
    }

    private static String line(int number, String symbol, String meaning) {
        return moved(0, number * KEY_LINE, symbol + "<text x='" + KEY_INDENT + "' y='4'>" + meaning + "</text>");
    }

    private static String moved(int x, int y, String elements) {
        return "<g transform='translate(" + x + " " + y + ")'>\n" + elements + "</g>\n";
    }

    /** A dot with a number in it. */
    static String disc(double x, double y, int series, int number) {
        return String.format(Locale.ROOT, "<circle class='s%d' cx='%.1f' cy='%.1f' r='7'/>"
                + "<text class='number' x='%.1f' y='%.1f' text-anchor='middle'>%d</text>\n", series, x, y, x, y + 3.2, number);
    }

    /** A line across the figure, in so small a font that it fits. */
    private static String across(String style, int y, int fontSize, String text, int width) {
        int fitting = Math.min(fontSize, (int) ((width - 2 * MARGIN) / (CHARACTER_WIDTH * text.length())));
        return String.format(Locale.ROOT, "<text class='%s' x='%d' y='%d' style='font-size:%dpx'>%s</text>\n", style, MARGIN,
                y, fitting, text);
    }
}
