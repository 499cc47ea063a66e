package raytracer.tracer;

import raytracer.parser.Scenes;
import raytracer.scene.Scene;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.arithmetic.Rounding;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.Surfaces;

/**
 * The tracer's own kernels for benchmarks: each of many rays against one sphere or triangle of its own, without a tree
 * in between.
 */
public final class KernelAccess {

    private final Surfaces surfaces;
    private final Rays[] tiles;
    private final int[][] numbers;

    /**
     * @param shapes  commands that declare spheres or triangles, all of one kind
     * @param origin  of each ray
     * @param targets which shape each ray is tried against, by number in the order of declaration
     */
    public KernelAccess(String shapes, Vector[] origin, Vector[] direction, int[] targets) throws Exception {
        Scene scene = Scenes.parse("size 1 1\ncamera 0 0 1 0 0 0 0 1 0 45\n" + shapes).scene();
        SurfaceCompiler compiler = new SurfaceCompiler(scene);
        surfaces = compiler.surfaces().get(0);
        int[] numberOf = new int[compiler.table().declared().length];
        for (int surface = 0; surface < numberOf.length; surface++) {
            numberOf[compiler.table().declared()[surface]] = surface;
        }
        int count = (origin.length + Batch.CAPACITY - 1) / Batch.CAPACITY;
        tiles = new Rays[count];
        numbers = new int[count][Batch.CAPACITY];
        for (int i = 0; i < origin.length; i++) {
            int tile = i / Batch.CAPACITY, ray = i % Batch.CAPACITY;
            if (ray == 0) {
                tiles[tile] = new Rays();
            }
            load(tiles[tile], ray, origin[i], direction[i]);
            numbers[tile][ray] = numberOf[targets[i]];
        }
    }

    private static void load(Rays rays, int ray, Vector o, Vector d) {
        rays.count = ray + 1;
        rays.ox[ray] = o.x();
        rays.oy[ray] = o.y();
        rays.oz[ray] = o.z();
        rays.dx[ray] = d.x();
        rays.dy[ray] = d.y();
        rays.dz[ray] = d.z();
        rays.source[ray] = Rays.NONE;
        rays.directionError[ray] = Rounding.EYE_DIRECTION;
    }

    /** Tries every ray; returns some number that depends on all. */
    public double run() {
        double sum = 0;
        for (int tile = 0; tile < tiles.length; tile++) {
            Rays rays = tiles[tile];
            rays.clearHits();
            for (int i = 0; i < rays.count; i++) {
                surfaces.intersect(rays, i, numbers[tile][i]);
            }
            sum += rays.distance[0];
        }
        return sum;
    }

    /** The distances of the last run; NaN where nothing is met. */
    public double[] distances() {
        double[] all = new double[(tiles.length - 1) * Batch.CAPACITY + tiles[tiles.length - 1].count];
        for (int i = 0; i < all.length; i++) {
            double t = tiles[i / Batch.CAPACITY].distance[i % Batch.CAPACITY];
            all[i] = Double.isInfinite(t) ? Double.NaN : t;
        }
        return all;
    }
}
