package raytracer.scene;

import java.util.Arrays;

/**
 * Vertices, and triangles that share them: 24 bytes a vertex and 12 a triangle. Immutable; made by a {@link Builder}.
 */
public final class Mesh {

    private final double[] coordinates;
    private final int[] corners;
    private final int triangles;

    private Mesh(double[] coordinates, int[] corners, int triangles) {
        this.coordinates = coordinates;
        this.corners = corners;
        this.triangles = triangles;
    }

    public int triangles() {
        return triangles;
    }

    /**
     * One coordinate of one corner.
     *
     * @param triangle from 0
     * @param corner   0, 1 or 2
     * @param axis     0, 1 or 2 for x, y or z
     */
    public double coordinate(int triangle, int corner, int axis) {
        return coordinates[3 * corners[3 * triangle + corner] + axis];
    }

    /** Corner 0, 1 or 2 of a triangle. */
    public Vector corner(int triangle, int corner) {
        return new Vector(
                coordinate(triangle, corner, 0), coordinate(triangle, corner, 1), coordinate(triangle, corner, 2));
    }

    /** The same triangles, each with its first two corners exchanged. */
    Mesh turned() {
        int[] turned = corners.clone();
        for (int i = 0; i < 3 * triangles; i += 3) {
            turned[i] = corners[i + 1];
            turned[i + 1] = corners[i];
        }
        return new Mesh(coordinates, turned, triangles);
    }

    /** Takes vertices and triangles one at a time, as a file declares them. Good for one mesh. */
    public static final class Builder {

        // A Java array ends a few elements short of 2^31, so a mesh ends near 715 million vertices or triangles.
        private static final int LARGEST_ARRAY = Integer.MAX_VALUE - 8;

        private double[] coordinates = new double[0];
        private int[] corners = new int[0];
        private int coordinateCount;
        private int cornerCount;

        public int vertices() {
            return coordinateCount / 3;
        }

        public int triangles() {
            return cornerCount / 3;
        }

        /** @throws OutOfMemoryError if no array can hold one more */
        public void addVertex(double x, double y, double z) {
            if (coordinateCount + 3 > coordinates.length) {
                coordinates = Arrays.copyOf(coordinates, grown(coordinates.length));
            }
            coordinates[coordinateCount++] = x;
            coordinates[coordinateCount++] = y;
            coordinates[coordinateCount++] = z;
        }

        /**
         * @param a a vertex that was added before, as are the others
         * @throws OutOfMemoryError if no array can hold one more
         */
        public void addTriangle(int a, int b, int c) {
            if (cornerCount + 3 > corners.length) {
                corners = Arrays.copyOf(corners, grown(corners.length));
            }
            corners[cornerCount++] = a;
            corners[cornerCount++] = b;
            corners[cornerCount++] = c;
        }

        /** Corner 0, 1 or 2 of the triangle added last. */
        public Vector corner(int corner) {
            int i = 3 * corners[cornerCount - 3 + corner];
            return new Vector(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        }

        public Mesh build() {
            return new Mesh(coordinates, corners, triangles());
        }

        private static int grown(int length) {
            int grown = (int) Math.min(length + (length >> 1) + 192L, LARGEST_ARRAY);
            if (grown < length + 3L) {
                throw new OutOfMemoryError("a mesh of more than " + LARGEST_ARRAY / 3 + " vertices or triangles");
            }
            return grown;
        }
    }
}
