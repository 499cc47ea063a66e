package raytracer.tracer;

import java.util.Arrays;

/**
 * Where a beam's rays go into a {@link Bvh}: some dozen of its nodes and leaves, instead of all at the root. Which of
 * them a ray's line passes is found for all rays by vector instructions; its own walk starts there (after Reshetov,
 * Soupikov and Hurley, Multi-Level Ray Tracing Algorithm, 2005, who have one entry point for all).
 */
final class EntryPoints {

    /** The most entry points: each costs all rays a test, and more of them spare fewer visits. */
    private static final int MOST = 24;

    /** A beam that opens fewer nodes for so many is too wide: nearly all rays would pass nearly all entry points. */
    private static final int FEWEST_OPENED = 12;

    /** Fewer rays than this are faster alone. */
    private static final int FEWEST_RAYS = 8;

    private Bvh bvh;
    private boolean narrow;

    // By entry point, the farthest first: where its box is among the nodes' numbers, and how far away.
    private final int[] box = new int[MOST + Bvh.WIDTH];
    private final double[] near = new double[MOST + Bvh.WIDTH];
    private int count;

    /** By ray: a bit for each entry point. */
    private final int[] passed = new int[Rays.CAPACITY];

    // In tree space: where rays start, and their lines' moments.
    private final Vectors origin = new Vectors();
    private final Vectors moment = new Vectors();
    private final double[] slack = new double[Rays.CAPACITY];

    /**
     * Finds the entry points of rays from one index to another.
     *
     * @param beam of these rays; it has given up its search of this tree
     */
    void find(Bvh tree, Beam beam, Vectors from, Vectors direction, int first, int end) {
        bvh = tree;
        narrow = tree.root() >= 0 && beam.isNarrow(tree) && end - first >= FEWEST_RAYS && descend(beam);
        if (narrow) {
            sort();
            if (beam.isBackwards()) {
                Arrays.fill(near, 0, count, 0);
            }
            Pass.run((i, j) -> pass(from, direction, i, j), first, end);
        }
    }

    /** Whether a ray's line passes any entry point. */
    boolean leadIn(int ray) {
        return !narrow || passed[ray] != 0;
    }

    /** Leads a ray in, which has started. */
    void enter(BvhWalk walk, int ray) {
        if (!narrow) {
            walk.enter(bvh.root(), 0);
            return;
        }
        for (int left = passed[ray]; left != 0; left &= left - 1) {
            int point = Integer.numberOfTrailingZeros(left);
            walk.enter(bvh.child(box[point]), near[point]);
        }
    }

    /** Opens the widest nodes, one after the other, into those of their children that the beam may meet. */
    private boolean descend(Beam beam) {
        count = 0;
        open(0, beam);
        int opened = 1;
        for (int widest = widest(); count + Bvh.WIDTH - 1 <= MOST && widest >= 0; widest = widest()) {
            int node = bvh.child(box[widest]);
            count--;
            box[widest] = box[count];
            near[widest] = near[count];
            open(node, beam);
            opened++;
        }
        return opened >= FEWEST_OPENED;
    }

    private void open(int node, Beam beam) {
        for (int child = 0; child < Bvh.WIDTH; child++) {
            int at = node * Bvh.NODE_STRIDE + child;
            double distance = beam.distance(bvh.nodes(), at);
            if (distance < Double.POSITIVE_INFINITY) {
                box[count] = at;
                near[count++] = distance;
            }
        }
    }

    /** The node among the entry points that has the widest box; negative if all are leaves. */
    private int widest() {
        float[] nodes = bvh.nodes();
        int widest = -1;
        float most = -1;
        for (int point = 0; point < count; point++) {
            int half = box[point] + Bvh.HALF;
            float width = nodes[half] + nodes[half + Bvh.AXIS_STRIDE] + nodes[half + 2 * Bvh.AXIS_STRIDE];
            if (width > most && bvh.child(box[point]) >= 0) {
                widest = point;
                most = width;
            }
        }
        return widest;
    }

    private void sort() {
        for (int i = 1; i < count; i++) {
            int movedBox = box[i];
            double movedNear = near[i];
            int to = i;
            for (; to > 0 && near[to - 1] < movedNear; to--) {
                box[to] = box[to - 1];
                near[to] = near[to - 1];
            }
            box[to] = movedBox;
            near[to] = movedNear;
        }
    }

    /**
     * Finds which entry points each ray's line passes, by its moment, origin x direction: a line passes a box if, seen
     * along each axis, it is no farther from the middle than the corner that reaches out most (after Mahovsky and
     * Wyvill, Fast Ray-Axis Aligned Bounding Box Overlap Tests with Pluecker Coordinates, 2004). In double, and no
     * farther from the tree than {@link Beam} allows, errors are far below the boxes' padding.
     */
    private void pass(Vectors from, Vectors d, int first, int end) {
        Vectors.toTreeSpace(from, bvh, 0, 0, 0, origin, first, end);
        Vectors.cross(origin, d, moment, first, end);
        Arrays.fill(passed, first, end, 0);
        float[] nodes = bvh.nodes();
        for (int point = 0; point < count; point++) {
            int x = box[point], y = x + Bvh.AXIS_STRIDE, z = y + Bvh.AXIS_STRIDE;
            float hx = nodes[x + Bvh.HALF], hy = nodes[y + Bvh.HALF], hz = nodes[z + Bvh.HALF];
            Arrays.fill(slack, first, end, Double.POSITIVE_INFINITY);
            Pass.run(new Limit(slack, moment.x(), d.y(), d.z(), nodes[y], nodes[z], hy, hz), first, end);
            Pass.run(new Limit(slack, moment.y(), d.z(), d.x(), nodes[z], nodes[x], hz, hx), first, end);
            Pass.run(new Limit(slack, moment.z(), d.x(), d.y(), nodes[x], nodes[y], hx, hy), first, end);
            mark(passed, point, slack, first, end);
        }
    }

    /** Limits the slack to what there is along one axis, of the other two: of the moment about the box's middle. */
    private record Limit(double[] slack, double[] moment, double[] dy, double[] dz,
            double y, double z, double halfY, double halfZ) implements Pass {
        @Override
        public void run(int first, int end) {
            for (int i = first; i < end; i++) {
                slack[i] = Math.min(slack[i], halfY * Math.abs(dz[i]) + halfZ * Math.abs(dy[i])
                        - Math.abs(moment[i] + z * dy[i] - y * dz[i]));
            }
        }
    }

    /** Notes the rays whose slack is not negative. */
    private static void mark(int[] passed, int point, double[] slack, int first, int end) {
        for (int i = first; i < end; i++) {
            passed[i] |= (int) (~Double.doubleToRawLongBits(slack[i]) >>> 63) << point;
        }
    }
}
