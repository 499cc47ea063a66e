package raytracer.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * A chart can be read: no text lies over another, over a dot or outside the picture; no dot lies over another or outside its
 * panel's frame; each is numbered, and its number is in the key.
 */
class LabelsTest {

    private static final Pattern MOVE = Pattern.compile("translate\\(([-0-9.]+) ([-0-9.]+)\\)");
    private static final Pattern SIZE = Pattern.compile("font-size:(\\d+)px");

    /** Of a font's size: characters are about so wide, bold ones more; a touch of a pixel is no harm. */
    private static final double PLAIN = .56, BOLD = .62;
    private static final double TOUCH = 1;

    private record Text(String words, double left, double top, double right, double bottom) {
        boolean covers(Text other) {
            return Math.min(right, other.right) - Math.max(left, other.left) > TOUCH
                    && Math.min(bottom, other.bottom) - Math.max(top, other.top) > TOUCH;
        }
    }

    private final List<Text> texts = new ArrayList<>();
    private final List<double[]> dots = new ArrayList<>();
    private final List<String> numbers = new ArrayList<>();
    private double width, height;

    @Test
    void chartsOfThePagesCanBeRead() throws Exception {
        try (Stream<Path> files = Files.list(Path.of("src", "site"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".svg")).toList()) {
                assertEquals(List.of(), faults(Files.readString(file)), file.toString());
            }
        }
    }

    @Test
    void crowdedPointsHaveDotsApart() throws Exception {
        Random random = new Random(1);
        for (int round = 0; round < 20; round++) {
            Panel panel = new Panel("A crowd", "ms", "error", 1e-4);
            panel.limit(1 / 255.0);
            for (int i = 0; i < 16; i++) {
                double x = 10 + 20 * random.nextDouble();
                panel.point("setting " + i, i % 5, x, .95 * x, 1.05 * x, i == 0 ? 0 : 1e-3 * (1 + random.nextDouble()));
            }
            Figure figure = new Figure("Heading", "foot", 1, 720, 500);
            figure.add(panel);
            figure.explain(2, "some");
            figure.explainBars("quartiles");
            figure.explainFront("the best");
            figure.explainLimit("RMSE of 1/255");
            figure.explainBand("the reference's own error");
            assertEquals(List.of(), faults(figure.svg()), "round " + round);
        }
    }

    @Test
    void axesEndWhereTheirValuesEnd() {
        Axis axis = Axis.around(List.of(430.0, 7664.0), 0);
        assertEquals(200, axis.low(), 1e-9);
        assertEquals(10_000, axis.high(), 1e-9);
        assertTrue(axis.ticks().containsAll(List.of(200.0, 1000.0, 10_000.0)), axis.ticks().toString());
    }

    @Test
    void zeroIsDrawnInTheBandOfNone() {
        Axis axis = Axis.around(List.of(0.0, 50.0), 10);
        assertTrue(axis.at(0) > 0 && axis.at(0) < axis.at(10));
    }

    private List<String> faults(String svg) throws Exception {
        texts.clear();
        dots.clear();
        numbers.clear();
        Element root = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8))).getDocumentElement();
        width = Double.parseDouble(root.getAttribute("width"));
        height = Double.parseDouble(root.getAttribute("height"));
        collect(root, 0, 0);
        assertTrue(texts.size() > 5 && !dots.isEmpty(), "nothing found to look at");
        List<String> faults = new ArrayList<>();
        for (int i = 0; i < texts.size(); i++) {
            Text a = texts.get(i);
            if (a.left < -TOUCH || a.top < -TOUCH || a.right > width + TOUCH || a.bottom > height + TOUCH) {
                faults.add(a.words + " is outside");
            }
            texts.subList(i + 1, texts.size()).stream().filter(a::covers)
                    .forEach(b -> faults.add(a.words + " and " + b.words));
            dots.stream().filter(d -> d[0] > a.left + TOUCH && d[0] < a.right - TOUCH && d[1] > a.top + TOUCH
                    && d[1] < a.bottom - TOUCH).forEach(d -> faults.add(a.words + " over a dot"));
        }
        for (int i = 0; i < dots.size(); i++) {
            double[] dot = dots.get(i);
            dots.subList(i + 1, dots.size()).stream().filter(d -> Math.hypot(d[0] - dot[0], d[1] - dot[1]) < dot[2] + d[2] - 1)
                    .forEach(d -> faults.add("dots at " + dot[0] + " " + dot[1]));
            if (dot[0] < dot[2] || dot[1] < dot[2] || dot[0] > width - dot[2] || dot[1] > height - dot[2]) {
                faults.add("a dot is outside at " + dot[0] + " " + dot[1]);
            }
        }
        numbers.stream().filter(n -> Collections.frequency(numbers, n) < 2).forEach(n -> faults.add("no key or dot for " + n));
        return faults;
    }

    private void collect(Element element, double x, double y) {
        Matcher move = MOVE.matcher(element.getAttribute("transform"));
        boolean isMoved = move.find();
        double dx = x + (isMoved ? Double.parseDouble(move.group(1)) : 0);
        double dy = y + (isMoved ? Double.parseDouble(move.group(2)) : 0);
        if (element.getTagName().equals("circle")) {
            dots.add(new double[] {dx + number(element, "cx"), dy + number(element, "cy"), number(element, "r")});
        } else if (element.getTagName().equals("text") && !element.getAttribute("transform").contains("rotate")) {
            addText(element, dx + number(element, "x"), dy + number(element, "y"));
        }
        for (Node child = element.getFirstChild(); child != null; child = child.getNextSibling()) {
            if (child instanceof Element inner) {
                collect(inner, dx, dy);
            }
        }
    }

    private void addText(Element element, double x, double y) {
        String words = element.getTextContent().strip(), style = element.getAttribute("class");
        Matcher given = SIZE.matcher(element.getAttribute("style"));
                double size = given.find() ? Integer.parseInt(given.group(1)) : style.equals("title") ? 12 : style.equals("foot") ? 10 : 11;
        boolean isBold = style.equals("heading") || style.equals("title");
        double length = size * words.length() * (isBold ? BOLD : PLAIN);
        String anchor = element.getAttribute("text-anchor");
        double left = x - (anchor.equals("end") ? length : anchor.equals("middle") ? length / 2 : 0);
        if (style.equals("number")) {
            numbers.add(words);
        } else if (!words.isEmpty()) {
            texts.add(new Text(words, left, y - .75 * size, left + length, y + .2 * size));
        }
    }

    private static double number(Element element, String attribute) {
        String value = element.getAttribute(attribute);
        return value.isEmpty() ? 0 : Double.parseDouble(value);
    }
}
