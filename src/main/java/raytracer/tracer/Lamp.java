package raytracer.tracer;

import raytracer.scene.Colour;
import raytracer.scene.Light;
import raytracer.scene.Vector;

/**
 * A light as the tracer wants it.
 *
 * @param directional whether it is at infinity
 * @param x           its position, or for a directional light the unit vector towards it
 */
record Lamp(boolean directional, double x, double y, double z, Colour colour) {

    /**
     * How far off a coordinate counts as being: a light that is meant to be on a surface is there only as well as
     * decimals say, and the corners of a triangle or the point of a plane are off as much.
     */
    double positionError() {
        return 4 * Rounding.U * (Math.abs(x) + Math.abs(y) + Math.abs(z));
    }

    static Lamp of(Light light) {
        Vector v = light instanceof Light.Directional d ? d.towards().unit() : ((Light.Point) light).position();
        return new Lamp(light instanceof Light.Directional, v.x(), v.y(), v.z(), light.colour());
    }
}
