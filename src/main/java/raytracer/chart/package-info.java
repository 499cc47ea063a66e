/**
 * Diagrams as SVG. In: labelled points. Out: text that a browser shows, in light and in dark. Must not know: what
 * the numbers mean.
 */
package raytracer.chart;
