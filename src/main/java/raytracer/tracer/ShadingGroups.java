package raytracer.tracer;

import java.util.Arrays;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.SurfaceTable;

/**
 * Puts a tile's rays in order by the material of what they have hit, so that all of a group arrive and are shaded by
 * the same rules and the same numbers. Most tiles have one or two groups.
 */
final class ShadingGroups {

    private final int[] materialIndex;

    int count;

    // By group: its material, and where its rays begin; they end where the next one's begin.
    final int[] material = new int[Batch.CAPACITY];
    final int[] start = new int[Batch.CAPACITY + 1];

    private final int[] order = new int[Batch.CAPACITY];
    private final boolean[] isListed = new boolean[Batch.CAPACITY];

    ShadingGroups(SurfaceTable table) {
        materialIndex = table.materialIndex();
    }

    /** Puts the rays in order; those that have hit nothing leave. */
    void arrange(Rays rays) {
        Arrays.fill(isListed, 0, rays.count, false);
        count = 0;
        start[0] = 0;
        for (int i = 0; i < rays.count; i++) {
            if (rays.hit[i] != Rays.NONE && !isListed[i]) {
                material[count] = materialIndex[rays.hit[i]];
                start[count + 1] = list(rays, i, start[count]);
                count++;
            }
        }
        if (count != 1 || start[1] != rays.count) {
            rays.select(order, start[count]);
        }
    }

    /** Lists the rays of the current group, of which this is the first; returns how many are listed then. */
    private int list(Rays rays, int first, int listed) {
        int end = listed;
        for (int i = first; i < rays.count; i++) {
            if (rays.hit[i] != Rays.NONE && materialIndex[rays.hit[i]] == material[count]) {
                order[end++] = i;
                isListed[i] = true;
            }
        }
        return end;
    }
}
