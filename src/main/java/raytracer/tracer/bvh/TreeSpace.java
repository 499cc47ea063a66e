package raytracer.tracer.bvh;

import raytracer.scene.Vector;

/**
 * The space of a tree: (world - centre) * scale. Centred, so that a scene far from the origin keeps its digits;
 * scaled by a power of two, so that a scene of another unit gets the same tree.
 */
public record TreeSpace(double centreX, double centreY, double centreZ, double scale) {

    public double x(double worldX) {
        return (worldX - centreX) * scale;
    }

    public double y(double worldY) {
        return (worldY - centreY) * scale;
    }

    public double z(double worldZ) {
        return (worldZ - centreZ) * scale;
    }

    public Vector of(Vector world) {
        return new Vector(x(world.x()), y(world.y()), z(world.z()));
    }

    /** The coordinate on an axis: 0 is x, 1 y, 2 z. */
    public double coordinate(int axis, double world) {
        return axis == 0 ? x(world) : axis == 1 ? y(world) : z(world);
    }
}
