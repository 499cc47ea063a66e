package raytracer.tracer.rays;

import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Rounding;

/**
 * A light as the tracer wants it.
 *
 * @param directional whether it is at infinity
 * @param x           its position, or for a directional light the unit vector towards it
 */
public record LightSource(boolean directional, double x, double y, double z, Colour colour) {

    /**
     * How far off it counts as being: a light that is meant to be on a surface is there only as well as decimals say,
     * and the corners of a triangle or the point of a plane are off as much.
     */
    public double positionError() {
        return 7 * Rounding.U * (Math.abs(x) + Math.abs(y) + Math.abs(z));
    }

    public static LightSource of(Light light) {
        Vector v = light instanceof Light.Directional d ? d.towards().unit() : ((Light.Point) light).position();
        return new LightSource(light instanceof Light.Directional, v.x(), v.y(), v.z(), light.colour());
    }
}
