package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracer.parser.Scenes;
import raytracer.render.Region;
import raytracer.render.Renderer;
import raytracer.render.Sampling;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.primitive.SphereBounds;
import raytracer.tracer.primitive.Spheres;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.search.ClosestHit;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** Laws that hold for every scene, whatever its picture is. */
class LawsTest {

    private static final int SPHERES = 60;

    /** Spheres and triangles that cross one another over a floor, all mirrors; every length times a factor. */
    private static String scene(double scale, boolean mirrored, long order) {
        Random random = new Random(3);
        List<String> shapes = new ArrayList<>();
        StringBuilder vertices = new StringBuilder();
        for (int i = 0; i < SPHERES; i++) {
            String colour = line("diffuse", .1 + random.nextInt(9) / 10.0, .1 + random.nextInt(9) / 10.0, .5);
            shapes.add(colour + line("sphere", x(random, scale, mirrored), coordinate(random, scale),
                    coordinate(random, scale), scale * (.1 + random.nextDouble() / 3)));
        }
        for (int i = 0; i < SPHERES; i++) {
            for (int corner = 0; corner < 3; corner++) {
                vertices.append(line("vertex", x(random, scale, mirrored), coordinate(random, scale),
                        coordinate(random, scale)));
            }
            int[] c = mirrored ? new int[] {0, 2, 1} : new int[] {0, 1, 2};
            shapes.add(line("diffuse", .5, random.nextInt(10) / 10.0, .2)
                    + "tri " + (3 * i + c[0]) + " " + (3 * i + c[1]) + " " + (3 * i + c[2]) + "\n");
        }
        shapes.add("diffuse .3 .3 .3\n" + line("plane", 0, -2 * scale, 0, 0, 1, 0));
        if (order != 0) {
            Collections.shuffle(shapes, new Random(order));
        }
        double side = mirrored ? -1 : 1;
        return "size 40 30\nmaxdepth 4\n" + line("camera", side * scale, scale, 6 * scale, 0, 0, 0, 0, scale, 0, 45)
                + line("point", side * 3 * scale, 5 * scale, 4 * scale, .5, .5, .5)
                + line("directional", -side, 2, 1, .4, .4, .4)
                + "specular .3 .3 .3\nshininess 20\nmaxverts " + 3 * SPHERES + "\n" + vertices + String.join("", shapes);
    }

    private static double x(Random random, double scale, boolean mirrored) {
        return mirrored ? -coordinate(random, scale) : coordinate(random, scale);
    }

    private static double coordinate(Random random, double scale) {
        return scale * (4 * random.nextDouble() - 2);
    }

    private static String line(String keyword, double... numbers) {
        StringBuilder line = new StringBuilder(keyword);
        for (double n : numbers) {
            line.append(String.format(Locale.ROOT, " %s", n));
        }
        return line.append('\n').toString();
    }

    @ParameterizedTest
    @ValueSource(ints = {-40, -7, 1, 3, 10, 40})
    void isTheSameToTheLastBitWhenEveryLengthIsScaledByAPowerOfTwo(int power) throws Exception {
        assertArrayEquals(Pictures.trace(scene(1, false, 0)),
                Pictures.trace(scene(Math.scalb(1.0, power), false, 0)), 0);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void isTheSameToTheLastBitInAnyOrderOfShapes(long order) throws Exception {
        assertArrayEquals(Pictures.trace(scene(1, false, 0)), Pictures.trace(scene(1, false, order)), 0);
    }

    @Test
    void isMirroredWhenTheSceneIs() throws Exception {
        double[] picture = Pictures.trace(scene(1, false, 0));
        double[] mirrored = Pictures.trace(scene(1, true, 0));
        for (int y = 0; y < 30; y++) {
            for (int x = 0; x < 40; x++) {
                int p = 3 * (40 * y + x), m = 3 * (40 * y + 39 - x);
                assertArrayEquals(Arrays.copyOfRange(picture, p, p + 3), Arrays.copyOfRange(mirrored, m, m + 3), 1e-9,
                        "pixel " + x + " " + y);
            }
        }
    }

    @Test
    void doesNotDependOnHowItIsCutIntoTiles() throws Exception {
        String text = scene(1, false, 0);
        double[] whole = Pictures.trace(text);
        Tracer tracer = Tracer.compile(Scenes.parse(text).scene());
        int[] seen = {0};
        for (int top = 0; top < 30; top += 7) {
            for (int left = 0; left < 40; left += 3) {
                int x0 = left, y0 = top;
                Region part = new Region(left, top, Math.min(3, 40 - left), Math.min(7, 30 - top));
                new Renderer(tracer, Sampling.CENTRES, 1, part, (x, y, columns, rows, r, g, b) -> {
                    for (int k = 0; k < columns * rows; k++) {
                        int i = 3 * (40 * (y0 + y + k / columns) + x0 + x + k % columns);
                        double[] colour = {r[k], g[k], b[k]};
                        assertArrayEquals(Arrays.copyOfRange(whole, i, i + 3), colour, 0);
                        seen[0]++;
                    }
                }).render();
            }
        }
        assertEquals(40 * 30, seen[0]);
    }

    @ParameterizedTest(name = "also {0} away from the origin, where a sphere's box is rounded")
    @ValueSource(doubles = {0, 1e9, 1e15})
    void isTheSameToTheLastBitWithAndWithoutATree(double away) throws Exception {
        double size = away < 1e12 ? 1 : 4;
        Random random = new Random(8);
        List<Shape.Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            spheres.add(new Shape.Sphere(new Vector(away + coordinate(random, size), coordinate(random, size), coordinate(random, size)),
                    size * (.05 + random.nextDouble() / 10), new Material(Colour.BLACK, Colour.BLACK, Colour.BLACK, 1)));
        }
        Bvh tree = BvhBuilder.build(500, new SphereBounds(spheres), Spheres.LEAF_SIZE);
        List<Shape.Sphere> ordered = Arrays.stream(tree.order()).mapToObj(spheres::get).toList();
        // Everything beside the tree: every ray tries every sphere.
        Surfaces with = new Spheres(ordered, 0, tree);
        Surfaces without = new Spheres(ordered, 0, Bvh.withoutTree(500));
        int met = 0;
        for (int i = 0; i < 5000; i++) {
            Vector o = new Vector(away + coordinate(random, 3 * size), coordinate(random, 3 * size), coordinate(random, 3 * size));
            Vector d = new Vector(away + coordinate(random, size), coordinate(random, size), coordinate(random, size)).minus(o).unit();
            Rays a = nearest(with, tree.order(), o, d), b = nearest(without, tree.order(), o, d);
            assertEquals(b.hit[0], a.hit[0]);
            assertEquals(b.distance[0], a.distance[0]);
            met += a.hit[0] != Rays.NONE ? 1 : 0;
        }
        assertTrue(met > 1000, met + " met");
    }

    private static Rays nearest(Surfaces surfaces, int[] declared, Vector o, Vector d) {
        Rays rays = new Rays();
        rays.count = 1;
        rays.ox[0] = o.x();
        rays.oy[0] = o.y();
        rays.oz[0] = o.z();
        rays.dx[0] = d.x();
        rays.dy[0] = d.y();
        rays.dz[0] = d.z();
        rays.source[0] = Rays.NONE;
        rays.clearHits();
        ClosestHit.among(surfaces, rays, new Workspace()).run(0, rays.count);
        return rays;
    }

    @Test
    void ofThisTestShowsSomething() throws Exception {
        double[] picture = Pictures.trace(scene(1, false, 0));
        assertTrue(Arrays.stream(picture).distinct().count() > 1000);
    }
}
