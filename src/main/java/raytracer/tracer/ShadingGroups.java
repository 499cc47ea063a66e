package raytracer.tracer;

import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.surface.SurfaceTable;

/**
 * Puts a tile's rays in order by the material of what they have hit, so that all of a group arrive and are shaded by
 * the same rules and the same numbers. Most tiles have one or two groups.
 */
final class ShadingGroups {

    private final int[] materialIndex;

    private int count;
    private final int[] materialOf = new int[Batch.CAPACITY];
    /** By group: its rays begin here, and end where the next one's begin. */
    private final int[] start = new int[Batch.CAPACITY + 1];

    private final int[] groupOf = new int[Batch.CAPACITY];
    private final int[] order = new int[Batch.CAPACITY];

    ShadingGroups(SurfaceTable table) {
        materialIndex = table.materialIndex();
    }

    int count() {
        return count;
    }

    int material(int group) {
        return materialOf[group];
    }

    int start(int group) {
        return start[group];
    }

    int end(int group) {
        return start[group + 1];
    }

    /** Puts the rays in order; those that have hit nothing leave. */
    void arrange(Rays rays) {
        int hitCount = assign(rays);
        if (count == 1 && hitCount == rays.count) {
            start[0] = 0;
            start[1] = hitCount;
        } else if (hitCount == 0) {
            rays.count = 0;
        } else {
            sort(rays);
            start[count] = hitCount;
            rays.select(order, hitCount);
        }
    }

    /** Lists rays by group. */
    private void sort(Rays rays) {
        for (int group = 1; group < count; group++) {
            start[group] += start[group - 1];
        }
        // From the last backwards, each group's rays fill it from its end, which so moves down to its start.
        for (int i = rays.count - 1; i >= 0; i--) {
            if (rays.hit[i] != Rays.NONE) {
                order[--start[groupOf[i]]] = i;
            }
        }
    }

    /** Tells every ray its group, and counts each group's rays in {@link #start}. */
    private int assign(Rays rays) {
        count = 0;
        int hitCount = 0;
        int group = -1;
        for (int i = 0; i < rays.count; i++) {
            int surface = rays.hit[i];
            if (surface != Rays.NONE) {
                if (group < 0 || materialOf[group] != materialIndex[surface]) {
                    group = find(materialIndex[surface]);
                }
                groupOf[i] = group;
                start[group]++;
                hitCount++;
            }
        }
        return hitCount;
    }

    private int find(int wanted) {
        for (int group = 0; group < count; group++) {
            if (materialOf[group] == wanted) {
                return group;
            }
        }
        materialOf[count] = wanted;
        start[count] = 0;
        return count++;
    }
}
