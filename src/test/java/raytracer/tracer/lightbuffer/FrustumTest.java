package raytracer.tracer.lightbuffer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import raytracer.scene.Vector;

@DisplayName("What a picture shows of the faces around the eye")
class FrustumTest {

    private static final double TAN_30 = Math.tan(Math.toRadians(30));

    private static final double[] EVERYWHERE = {-9, -9, -9};

    /** By face: its part with cells, of things all around the eye. */
    private static double[] areas(Vector... corners) {
        return Arrays.stream(CubeFace.around()).mapToDouble(face -> {
            face.include(EVERYWHERE.clone(), new double[] {9, 9, 9});
            new Frustum(Arrays.asList(corners)).limit(face);
            return face.area();
        }).toArray();
    }

    private static void assertAreas(double[] expected, Vector... corners) {
        double[] areas = areas(corners);
        for (int face = 0; face < 6; face++) {
            assertEquals(expected[face], areas[face], 1e-12, "face " + face);
        }
    }

    @Test
    void isNothingWhereThereIsNothingToSee() {
        CubeFace face = CubeFace.around()[5];
        // Things are on the right, and the picture shows what is on the left.
        face.include(new double[] {.5, -1, -1.1}, new double[] {.9, 1, -1});
        assertTrue(face.overlaps(-1, 1, -1, 1));
        new Frustum(List.of(new Vector(-.9, 1, -1), new Vector(-.5, 1, -1), new Vector(-.5, -1, -1),
                new Vector(-.9, -1, -1))).limit(face);
        assertFalse(face.overlaps(-1, 1, -1, 1));
        assertEquals(0, face.divide(.1, 0));
    }

    @Test
    void isARectangleAlongAnAxis() {
        assertAreas(new double[] {0, 0, 0, 0, 0, 4 * TAN_30 * .5}, new Vector(-TAN_30, .5, -1),
                new Vector(TAN_30, .5, -1), new Vector(TAN_30, -.5, -1), new Vector(-TAN_30, -.5, -1));
    }

    @Test
    void isPartOfEachOfTwoFacesInBetween() {
        // From 15 to 75 degrees between the axes x and y: each face is seen from tan 15 to its edge, where the upper
        // border is highest, as it is nearest there.
        double c = Math.cos(Math.toRadians(15)), s = Math.sin(Math.toRadians(15)), up = .25;
        double area = (1 - s / c) * 2 * up / ((c + s) / 2);
        assertAreas(new double[] {area, 0, area, 0, 0, 0}, new Vector(c, s, up), new Vector(s, c, up),
                new Vector(s, c, -up), new Vector(c, s, -up));
    }

    @Test
    void isTheWholeFaceAheadAndMostOfThoseBesideIfItIsWide() {
        // 10 times as wide and high as it is far: faces beside are seen up to a tenth of their depth.
        double[] areas = areas(new Vector(-10, 10, -1), new Vector(10, 10, -1), new Vector(10, -10, -1),
                new Vector(-10, -10, -1));
        assertEquals(4, areas[5], 1e-12);
        assertEquals(0, areas[4]);
        for (int face = 0; face < 4; face++) {
            assertEquals(2 * .9, areas[face], 1e-12, "face " + face);
        }
    }
}
