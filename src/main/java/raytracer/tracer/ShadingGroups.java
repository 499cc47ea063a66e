package raytracer.tracer;

import raytracer.tracer.kernel.Batch;
import raytracer.tracer.primitive.SurfaceTable;
import raytracer.tracer.rays.Rays;

/**
 * Puts a tile's rays in order by the look of what they have met, so that all of a group arrive and are shaded by the
 * same rules and the same numbers. Most tiles have one or two groups.
 */
final class ShadingGroups {

    private final int[] look;

    private int count;
    private final int[] lookOf = new int[Batch.CAPACITY];
    /** By group: its rays begin here, and end where the next one's begin. */
    private final int[] start = new int[Batch.CAPACITY + 1];

    private final int[] groupOf = new int[Batch.CAPACITY];
    private final int[] order = new int[Batch.CAPACITY];

    ShadingGroups(SurfaceTable slots) {
        look = slots.look();
    }

    int count() {
        return count;
    }

    int look(int group) {
        return lookOf[group];
    }

    int start(int group) {
        return start[group];
    }

    int end(int group) {
        return start[group + 1];
    }

    /** Puts the rays in order; those that have met nothing leave. */
    void arrange(Rays rays) {
        int met = rays.hit[0] != Rays.NONE && rays.haveMetTheSame(0, rays.count) ? makeOne(rays) : assign(rays);
        if (count == 1 && met == rays.count) {
            start[0] = 0;
            start[1] = met;
        } else if (met == 0) {
            rays.count = 0;
        } else {
            sort(rays);
            start[count] = met;
            rays.select(order, met);
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

    private int makeOne(Rays rays) {
        count = 1;
        lookOf[0] = look[rays.hit[0]];
        return rays.count;
    }

    /** Tells every ray its group, and counts each group's rays in {@link #start}. */
    private int assign(Rays rays) {
        count = 0;
        int met = 0;
        int group = -1;
        for (int i = 0; i < rays.count; i++) {
            int slot = rays.hit[i];
            if (slot != Rays.NONE) {
                if (group < 0 || lookOf[group] != look[slot]) {
                    group = find(look[slot]);
                }
                groupOf[i] = group;
                start[group]++;
                met++;
            }
        }
        return met;
    }

    private int find(int wanted) {
        for (int group = 0; group < count; group++) {
            if (lookOf[group] == wanted) {
                return group;
            }
        }
        lookOf[count] = wanted;
        start[count] = 0;
        return count++;
    }
}
