package raytracer.tracer;

/**
 * Builds {@link LightBuffer}s. All things are looked at three times: to find which parts of the faces they take up, to
 * count each cell's, and to sort them in.
 */
final class LightBufferBuilder {

    /** If things are in more cells than this on average, they are too large for cells to be of use. */
    private static final int MOST_ENTRIES = 16;

    private final Bvh bvh;
    private final Hulls hulls;
    /** In the tree's space. */
    private final double[] lamp;
    private final Face[] faces;
    private final int count;
    private final Outline outline = new Outline();

    /** By cell: how many things are there; then where the next entry goes. */
    private int[] next;
    private long entries;
    private long[] sorted;

    private LightBufferBuilder(Bvh bvh, Hulls hulls, double[] lamp, Face[] faces) {
        this.bvh = bvh;
        this.hulls = hulls;
        this.lamp = lamp;
        this.faces = faces;
        count = bvh.order().length - bvh.beside();
    }

    /**
     * Sorts the things of a tree by where a lamp sees them.
     *
     * @param hulls by number in the tree's order
     * @return null if that would be no use
     */
    static LightBuffer build(Bvh bvh, Hulls hulls, Lamp of) {
        if (of.directional()) {
            Face[] faces = {Face.of(of.x(), of.y(), of.z())};
            return new LightBufferBuilder(bvh, hulls, new double[3], faces).build();
        }
        double[] lamp = {(of.x() - bvh.centreX()) * bvh.scale(), (of.y() - bvh.centreY()) * bvh.scale(),
            (of.z() - bvh.centreZ()) * bvh.scale()};
        for (double coordinate : lamp) {
            if (!(Math.abs(coordinate) < Beam.FARTHEST)) {
                return null;
            }
        }
        return new LightBufferBuilder(bvh, hulls, lamp, Face.around()).build();
    }

    private LightBuffer build() {
        look((k, face) -> face.include(outline));
        double area = 0;
        for (Face face : faces) {
            area += face.area();
        }
        int cells = 0;
        for (Face face : faces) {
            cells += face.divide(Math.sqrt(area / count), cells);
        }
        next = new int[cells];
        look(this::count);
        if (entries > mostEntries()) {
            return null;
        }
        int[] start = sumUp();
        sorted = new long[start[cells] + 1];
        look(this::sortIn);
        return new LightBuffer(bvh, lamp, faces, start, sorted);
    }

    private long mostEntries() {
        return Math.min(Integer.MAX_VALUE - 8, MOST_ENTRIES * (long) count);
    }

    /** What is done about thing k, which is seen on a face. */
    private interface Sight {
        void of(int k, Face face);
    }

    private void look(Sight sight) {
        for (int k = bvh.beside(); k < bvh.order().length; k++) {
            look(k, sight);
        }
    }

    private void look(int k, Sight sight) {
        double[] hull = outline.hull();
        hulls.of(k, hull);
        toTreeSpace(hull);
        int only = faces.length == 1 ? 0 : outline.onlyFace();
        int first = Math.max(0, only), last = only < 0 ? faces.length - 1 : only;
        for (int face = first; face <= last; face++) {
            if (outline.isSeenOn(faces[face])) {
                sight.of(k, faces[face]);
            }
        }
    }

    /** Brings a hull from world space to the tree's, as seen from the lamp. */
    private void toTreeSpace(double[] hull) {
        for (int corner = 0; corner < Hulls.RADIUS; corner += 3) {
            hull[corner] = (hull[corner] - bvh.centreX()) * bvh.scale() - lamp[0];
            hull[corner + 1] = (hull[corner + 1] - bvh.centreY()) * bvh.scale() - lamp[1];
            hull[corner + 2] = (hull[corner + 2] - bvh.centreZ()) * bvh.scale() - lamp[2];
        }
        hull[Hulls.RADIUS] = hull[Hulls.RADIUS] * bvh.scale() + Bvh.PADDING;
    }

    private void count(int k, Face face) {
        int lastRow = outline.lastRow(face);
        for (int row = outline.firstRow(face); row <= lastRow && entries <= mostEntries(); row++) {
            int last = face.cell(outline.lastColumn(face, row), row);
            for (int cell = face.cell(outline.firstColumn(face, row), row); cell <= last; cell++) {
                next[cell]++;
                entries++;
            }
        }
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

    private void sortIn(int k, Face face) {
        float depth = Math.nextDown((float) outline.nearest());
        int lastRow = outline.lastRow(face);
        for (int row = outline.firstRow(face); row <= lastRow; row++) {
            int last = face.cell(outline.lastColumn(face, row), row);
            for (int cell = face.cell(outline.firstColumn(face, row), row); cell <= last; cell++) {
                sorted[next[cell]++] = LightBuffer.entry(k, depth);
            }
        }
    }
}
