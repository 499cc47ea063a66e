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

    static Lamp of(Light light) {
        Vector v = light instanceof Light.Directional d ? d.towards().unit() : ((Light.Point) light).position();
        return new Lamp(light instanceof Light.Directional, v.x(), v.y(), v.z(), light.colour());
    }
}
