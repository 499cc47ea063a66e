package raytracer.tracer.lightbuffer;

import java.util.Arrays;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.rays.LightSource;

/**
 * Builds {@link LightBuffer}s: it is noted which primitives are seen in which cells, and counted how many in each; then
 * they are sorted in. Which parts of the faces they take up is known from the tree's boxes.
 */
public final class LightBufferBuilder {

    /** If primitives are in more cells than this on average, they are too large for cells to be of use. */
    private static final int MAX_ENTRIES = 10;

    /** The most memory that building takes for a primitive: of its entries, noted and sorted, and twice of its cell. */
    static final long MAX_BYTES = MAX_ENTRIES * (Integer.BYTES + Long.BYTES) + 3 * Integer.BYTES + 2 * Integer.BYTES;

    /** And so they are if the boxes around their outlines have more cells than this. */
    private static final int MAX_TRIED = 64;

    /** How far down the tree the boxes are that show which parts of the faces it takes up: of 4^5 at most. */
    private static final int LEVELS = 4;

    private final Bvh bvh;
    private final BoundingShapes shapes;
    /** In the tree's space. */
    private final double[] source;
    private final CubeFace[] faces;
    private final int count;
    private final ProjectedOutline outline = new ProjectedOutline();

    /**
     * By primitive and face: the primitive, the key of its least depth, in how many cells it is seen there, and in
     * which.
     */
    private final IntQueue sightings = new IntQueue();

    /** By cell: how many primitives are there; then where the next entry goes. */
    private int[] next;
    private long tried;
    private long entries;
    private long[] sorted;

    private LightBufferBuilder(Bvh bvh, BoundingShapes shapes, double[] source, CubeFace[] faces) {
        this.bvh = bvh;
        this.shapes = shapes;
        this.source = source;
        this.faces = faces;
        count = bvh.order().length - bvh.oversized();
    }

    /**
     * Sorts the primitives of a tree by where a light sees them.
     *
     * @param shapes by number in the tree's order
     * @return null if that would be no use
     */
    static LightBuffer build(Bvh bvh, BoundingShapes shapes, LightSource of) {
        if (bvh.root() < 0) {
            return null;
        }
        if (of.directional()) {
            CubeFace[] faces = {CubeFace.of(of.x(), of.y(), of.z())};
            return new LightBufferBuilder(bvh, shapes, new double[3], faces).build();
        }
        double[] source = {bvh.space().x(of.x()), bvh.space().y(of.y()), bvh.space().z(of.z())};
        for (double coordinate : source) {
            if (!(Math.abs(coordinate) < Bvh.FARTHEST)) {
                return null;
            }
        }
        return new LightBufferBuilder(bvh, shapes, source, CubeFace.around()).build();
    }

    private LightBuffer build() {
        include(bvh.root(), LEVELS);
        double area = 0;
        for (CubeFace face : faces) {
            area += face.area();
        }
        int cells = 0;
        for (CubeFace face : faces) {
            cells += face.divide(Math.sqrt(area / count), cells);
        }
        next = new int[cells];
        project();
        if (isTooMuch()) {
            return null;
        }
        int[] start = sumUp();
        sorted = new long[start[cells] + 1];
        sortIn();
        sortByDepth(start);
        return new LightBuffer(bvh, source, faces, start, sorted);
    }

    /** Shows the faces a part of the tree, by its boxes so many levels down. */
    private void include(int node, int levels) {
        for (int at = node * Bvh.NODE_STRIDE; at < node * Bvh.NODE_STRIDE + Bvh.WIDTH; at++) {
            // Boxes of no children are as wide as less than nothing.
            if (bvh.nodes()[at + Bvh.HALF] >= 0) {
                if (levels > 0 && bvh.child(at) >= 0) {
                    include(bvh.child(at), levels - 1);
                } else {
                    include(at);
                }
            }
        }
    }

    /** Shows the faces a box, which is at this place among the nodes' numbers. */
    private void include(int at) {
        double[] min = new double[3], max = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double middle = bvh.nodes()[at + axis * Bvh.AXIS_STRIDE] - source[axis];
            double half = bvh.nodes()[at + axis * Bvh.AXIS_STRIDE + Bvh.HALF] + Bvh.PADDING;
            min[axis] = middle - half;
            max[axis] = middle + half;
        }
        for (CubeFace face : faces) {
            face.include(min, max);
        }
    }

    private boolean isTooMuch() {
        return tried > MAX_TRIED * (long) count
                || entries > Math.min(Integer.MAX_VALUE - 8, MAX_ENTRIES * (long) count);
    }

    /** Notes where primitives are seen. */
    private void project() {
        int end = bvh.order().length;
        for (int k = bvh.oversized(); k < end && !isTooMuch(); k++) {
            setOutline(k);
            int only = faces.length == 1 ? 0 : outline.onlyFace();
            int first = Math.max(0, only), last = only < 0 ? faces.length - 1 : only;
            for (int face = first; face <= last; face++) {
                if (outline.isSeenOn(faces[face])) {
                    note(k, faces[face]);
                }
            }
        }
    }

    private void setOutline(int k) {
        for (int corner = 0; corner < 3; corner++) {
            Vector v = shapes.corner(k, corner);
            outline.setCorner(corner, bvh.space().x(v.x()) - source[0], bvh.space().y(v.y()) - source[1],
                    bvh.space().z(v.z()) - source[2]);
        }
        outline.setRadius(shapes.radius(k) * bvh.space().scale());
    }

    /** Primitive k is seen on a face. */
    private void note(int k, CubeFace face) {
        tried += outline.cellsAround(face);
        if (isTooMuch()) {
            return;
        }
        int found = outline.findCells(face);
        sightings.add(k);
        sightings.add(LightBuffer.key(Math.nextDown((float) outline.nearest())));
        sightings.add(found);
        for (int n = 0; n < found; n++) {
            sightings.add(outline.cell(n));
            next[outline.cell(n)]++;
        }
        entries += found;
    }

    /** Makes of the counts where each cell's entries begin. */
    private int[] sumUp() {
        int[] start = new int[next.length + 1];
        for (int cell = 0; cell < next.length; cell++) {
            start[cell + 1] = start[cell] + next[cell];
            next[cell] = start[cell];
        }
        return start;
    }

    /** A ray needs only look at the first of its cell, and what is nearest to the source darkens most. */
    private void sortByDepth(int[] start) {
        for (int cell = 0; cell < next.length; cell++) {
            Arrays.sort(sorted, start[cell], start[cell + 1]);
        }
    }

    private void sortIn() {
        while (sightings.isLeft()) {
            int k = sightings.take();
            long entry = LightBuffer.entry(k, sightings.take());
            for (int left = sightings.take(); left > 0; left--) {
                sorted[next[sightings.take()]++] = entry;
            }
        }
    }
}
