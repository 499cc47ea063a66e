package raytracer.exact;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import raytracer.scene.Vector;

/** A tree of boxes. */
class BoxTreeTest {

    @Test
    @DisplayName("finds every box that a ray is aimed at, flat or large, near or far, and every item without one")
    void leavesNothingOut() {
        Random random = new Random(1);
        for (int round = 0; round < 200; round++) {
            double far = Math.pow(10, random.nextInt(8));
            double[][] boxes = new double[1 + random.nextInt(60)][];
            for (int i = 1; i < boxes.length; i++) {
                boxes[i] = box(random, far);
            }
            BoxTree tree = new BoxTree(boxes);
            for (int i = 1; i < boxes.length; i++) {
                Vector eye = point(random, box(random, far)), at = point(random, boxes[i]);
                Set<Integer> found = new HashSet<>();
                tree.find(eye, at.minus(eye).unit(), found::add);
                assertTrue(found.contains(0) && found.contains(i), "round " + round + ", box " + i);
            }
        }
    }

    private static double[] box(Random random, double far) {
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = far * random.nextGaussian();
            box[axis + 3] = box[axis] + (random.nextInt(4) == 0 ? 0 : Math.pow(10, 6 * random.nextDouble() - 5));
        }
        return box;
    }

    private static Vector point(Random random, double[] box) {
        double[] p = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            p[axis] = box[axis] + (box[axis + 3] - box[axis]) * random.nextDouble();
        }
        return new Vector(p[0], p[1], p[2]);
    }
}
