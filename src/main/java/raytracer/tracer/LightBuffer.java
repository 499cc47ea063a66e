package raytracer.tracer;

/**
 * The things of a {@link Bvh} by the direction in which a lamp sees them: whatever may be in a shadow ray's way is in
 * the one cell in which the lamp sees where the ray starts (Haines and Greenberg, The Light Buffer: A Shadow-Testing
 * Accelerator, 1986). Trying those takes about half of the time of a walk through the tree.
 *
 * <p>As in a {@link Beam}, everything is in the tree's space and in double, of points not too far away, so that errors
 * are far below the boxes' padding; things are taken for larger by as much.
 */
final class LightBuffer {

    private final Bvh bvh;
    private final boolean directional;
    private final double lampX;
    private final double lampY;
    private final double lampZ;
    private final Face[] faces;

    /** By cell, where its entries begin; they end where the next one's begin. */
    private final int[] start;

    // By entry: the thing, in the tree's order, and the least depth of any of its points.
    private final int[] thing;
    private final float[] nearest;

    LightBuffer(Bvh bvh, double[] lamp, Face[] faces, int[] start, int[] thing, float[] nearest) {
        this.bvh = bvh;
        lampX = lamp[0];
        lampY = lamp[1];
        lampZ = lamp[2];
        this.faces = faces;
        directional = faces.length == 1;
        this.start = start;
        this.thing = thing;
        this.nearest = nearest;
    }

    /** Where a shadow ray starts, in the tree's space, and the entries of the cell there. Serves ray after ray. */
    static final class Cell {
        double x;
        double y;
        double z;
        private double depth;
        int first;
        int end;
    }

    /** Whether all rays, from one index to another, start near enough to be looked up. */
    boolean reaches(Rays rays, int from, int to) {
        double farthest = 0;
        for (int i = from; i < to; i++) {
            double x = Math.abs(rays.ox[i] - bvh.centreX()), y = Math.abs(rays.oy[i] - bvh.centreY());
            double z = Math.abs(rays.oz[i] - bvh.centreZ());
            farthest = Math.max(farthest, Math.max(x, Math.max(y, z)));
        }
        return farthest * bvh.scale() < Beam.FARTHEST;
    }

    /** Finds the cell in which the lamp sees the point where a ray starts. */
    void find(double worldX, double worldY, double worldZ, Cell cell) {
        cell.x = (worldX - bvh.centreX()) * bvh.scale();
        cell.y = (worldY - bvh.centreY()) * bvh.scale();
        cell.z = (worldZ - bvh.centreZ()) * bvh.scale();
        double x = cell.x - lampX, y = cell.y - lampY, z = cell.z - lampZ;
        Face face = faces[directional ? 0 : Face.number(x, y, z)];
        cell.depth = face.depth(x, y, z);
        int at = face.cell(x, y, z);
        cell.first = at < 0 ? 0 : start[at];
        cell.end = at < 0 ? 0 : start[at + 1];
    }

    /** Whether part of an entry's thing may be nearer to the lamp than the point that was looked up. */
    boolean isNearer(int entry, Cell cell) {
        return nearest[entry] <= cell.depth;
    }

    int thing(int entry) {
        return thing[entry];
    }
}
