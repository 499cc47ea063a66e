package raytracer.tracer.lightbuffer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.bvh.Bounds;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.primitive.Spheres;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.primitive.Triangles;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Progress;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.search.AnyHit;
import raytracer.tracer.search.SearchWorkspace;

@DisplayName("A light buffer")
public class LightBufferTest {

    private static final int COUNT = 500;
    public static final Vector ORIGIN = new Vector(0, 0, 0);

    /** No buffers. */
    public static final Viewpoints NONE = new Viewpoints(List.of(), new Progress());

    /** So much work is ahead that buffers are built soon. */
    private static Viewpoints viewpoints(LightSource lamp) {
        Progress progress = new Progress();
        progress.expect(Integer.MAX_VALUE);
        return new Viewpoints(List.of(lamp), progress);
    }

    private static double coordinate(Random random, double size) {
        return size * (2 * random.nextDouble() - 1);
    }

    private static Vector within(Random random, double size) {
        return new Vector(coordinate(random, size), coordinate(random, size), coordinate(random, size));
    }

    private static Vector plus(Vector a, double t, Vector b) {
        return new Vector(a.x() + t * b.x(), a.y() + t * b.y(), a.z() + t * b.z());
    }

    private static LightSource lamp(boolean directional, Vector v) {
        return new LightSource(directional, v.x(), v.y(), v.z(), Colour.BLACK);
    }

    public static Mesh triangles(Random random, Vector middle, double size) {
        Mesh.Builder mesh = new Mesh.Builder();
        for (int k = 0; k < COUNT; k++) {
            Vector place = plus(middle, 1, within(random, 1));
            for (int corner = 0; corner < 3; corner++) {
                Vector v = plus(place, 1, within(random, size));
                mesh.addVertex(v.x(), v.y(), v.z());
            }
            mesh.addTriangle(3 * k, 3 * k + 1, 3 * k + 2);
        }
        return mesh.build();
    }

    public static Mesh scaled(Mesh mesh, double size) {
        Mesh.Builder scaled = new Mesh.Builder();
        for (int k = 0; k < mesh.triangles(); k++) {
            for (int corner = 0; corner < 3; corner++) {
                Vector v = mesh.corner(k, corner).times(size);
                scaled.addVertex(v.x(), v.y(), v.z());
            }
            scaled.addTriangle(3 * k, 3 * k + 1, 3 * k + 2);
        }
        return scaled.build();
    }

    public static List<Shape.Sphere> spheres(Random random, Vector middle, double size) {
        return IntStream.range(0, COUNT).mapToObj(k -> new Shape.Sphere(
                plus(middle, 1, within(random, 1)), size * (.1 + random.nextDouble()), Material.DEFAULT)).toList();
    }

    private static Bvh tree(Mesh mesh) {
        return tree(mesh, 0);
    }

    /** Of triangles that are thick. */
    private static Bvh tree(Mesh mesh, double radius) {
        Bounds flat = Triangles.bounds(mesh);
        Bounds thick = (k, box) -> {
            flat.of(k, box);
            for (int axis = 0; axis < 3; axis++) {
                box[axis] -= radius;
                box[axis + 3] += radius;
            }
        };
        return BvhBuilder.build(COUNT, thick, Triangles.LEAF_SIZE, ForkJoinPool.commonPool());
    }

    private static Bvh tree(List<Shape.Sphere> spheres) {
        return BvhBuilder.build(COUNT, Spheres.bounds(spheres), Spheres.LEAF_SIZE, ForkJoinPool.commonPool());
    }

    private static List<Shape.Sphere> inOrder(Bvh bvh, List<Shape.Sphere> spheres) {
        return Arrays.stream(bvh.order()).mapToObj(spheres::get).toList();
    }

    /** Triangles that are thick, so that what is outside of their edges counts as much as a sphere does. */
    /** Triangles by their numbers in a tree, and all that is no farther from them than a radius. */
    private static BoundingShapes shapes(Mesh mesh, Bvh bvh, double radius) {
        return new BoundingShapes() {
            @Override
            public Vector corner(int k, int corner) {
                return mesh.corner(bvh.order()[k], corner);
            }

            @Override
            public double radius(int k) {
                return radius;
            }
        };
    }

    private static BoundingShapes shapes(Bvh bvh, List<Shape.Sphere> spheres) {
        return new Spheres(inOrder(bvh, spheres), 0, bvh, NONE);
    }

    private static long assertHasAllInTheWay(Bvh bvh, BoundingShapes shapes, LightSource lamp, Random random) {
        LightBuffer buffer = LightBufferBuilder.build(bvh, shapes, lamp);
        assertNotNull(buffer);
        LightBuffer.Cells cells = new LightBuffer.Cells();
        Rays rays = new Rays();
        Vector light = new Vector(lamp.x(), lamp.y(), lamp.z());
        long entries = 0;
        for (int i = 0; i < 20_000; i++) {
            int k = bvh.oversized() + random.nextInt(COUNT - bvh.oversized());
            Vector q = pointOf(shapes, k, random);
            Vector way = lamp.directional() ? light.times(-1) : q.minus(light);
            if (way.isZero()) {
                continue;
            }
            double beyond = random.nextInt(3) == 0 ? 1e-9 : random.nextDouble() * random.nextInt(4);
            Vector o = plus(q, beyond, way);
            rays.ox[0] = o.x();
            rays.oy[0] = o.y();
            rays.oz[0] = o.z();
            assertTrue(buffer.isNearEnough(rays, 0, 1), "point " + i);
            buffer.find(rays, 0, 1, cells);
            int[] nearer = IntStream.range(cells.first[0], cells.end[0])
                    .filter(entry -> buffer.isNearer(entry, 0, cells)).map(buffer::primitive).toArray();
            assertTrue(Arrays.stream(nearer).anyMatch(thing -> thing == k), "point " + i);
            entries += nearer.length;
        }
        return entries / 20_000;
    }

    /** A point of a bounding shape: inside, or often on an edge or in a corner; on or in a sphere around that. */
    private static Vector pointOf(BoundingShapes shapes, int k, Random random) {
        double u = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
        double v = u == 1 ? 0 : random.nextInt(3) == 0 ? 0 : (1 - u) * random.nextDouble();
        Vector a = shapes.corner(k, 0);
        Vector flat = plus(plus(a, u, shapes.corner(k, 1).minus(a)), v, shapes.corner(k, 2).minus(a));
        Vector outwards = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
        return plus(flat, shapes.radius(k) * (random.nextBoolean() ? 1 : random.nextDouble()), outwards);
    }

    @ParameterizedTest(name = "has what is in a ray''s way: world offset {0}, things of {1}, lamp {2} away")
    @CsvSource({"0, .05, 3", "0, .12, 3", "1e6, .05, 3", "-1e9, .1, 2", "0, .05, 1e5", "0, 1e-7, 3", "0, 1e-12, 3",
        "0, .05, .9", "0, .05, 0", "0, .001, .5"})
    void hasWhatIsInTheWay(double offset, double size, double away) {
        Random random = new Random(1);
        Vector middle = new Vector(offset, -offset, offset / 2);
        for (int round = 0; round < 3; round++) {
            Mesh mesh = triangles(random, middle, size);
            List<Shape.Sphere> balls = spheres(random, middle, size);
            Bvh flat = tree(mesh), thick = tree(mesh, size / 8), curved = tree(balls);
            for (int kind = 0; kind < 3; kind++) {
                Vector towards = kind == 2 ? within(random, 1).unit() : plus(middle, away, within(random, 1).unit());
                LightSource lamp = lamp(kind == 2, towards);
                long tried = assertHasAllInTheWay(flat, shapes(mesh, flat, 0), lamp, random)
                        + assertHasAllInTheWay(thick, shapes(mesh, thick, size / 8), lamp, random)
                        + assertHasAllInTheWay(curved, shapes(curved, balls), lamp, random);
                assertTrue(tried < 3 * COUNT / 10, tried + " of " + 3 * COUNT + " things tried");
            }
        }
    }

    @Test
    void hasWhatIsInTheWayToALampOnAThing() {
        Random random = new Random(2);
        Mesh mesh = triangles(random, ORIGIN, .2);
        Bvh bvh = tree(mesh);
        Vector a = mesh.corner(7, 0), b = mesh.corner(7, 1), c = mesh.corner(7, 2);
        for (Vector on : List.of(a, plus(a, .5, b.minus(a)), plus(plus(a, .25, b.minus(a)), .25, c.minus(a)))) {
            assertHasAllInTheWay(bvh, shapes(mesh, bvh, 0), lamp(false, on), random);
        }
    }

    @Test
    void hasWhatIsInTheWayAlongTheAxes() {
        Random random = new Random(3);
        List<Shape.Sphere> spheres = spheres(random, ORIGIN, .1);
        Bvh bvh = tree(spheres);
        for (Vector axis : List.of(new Vector(1, 0, 0), new Vector(-1, 0, 0), new Vector(0, -1, 0),
                new Vector(0, 0, 1), new Vector(1, 1, 0).unit(), new Vector(1, -1, 1).unit())) {
            for (boolean directional : new boolean[] {false, true}) {
                assertHasAllInTheWay(bvh, shapes(bvh, spheres),
                        lamp(directional, directional ? axis : axis.times(4)), random);
            }
        }
    }

    @Test
    void isNotBuiltIfThingsAreTooLargeForCellsOrTheLampIsTooFarAway() {
        Random random = new Random(4);
        List<Shape.Sphere> large = spheres(random, ORIGIN, .7);
        Bvh bvh = tree(large);
        assertNull(LightBufferBuilder.build(bvh, shapes(bvh, large), lamp(false, new Vector(0, 2, 0))));
        List<Shape.Sphere> small = spheres(random, ORIGIN, .05);
        Bvh other = tree(small);
        BoundingShapes hulls = shapes(other, small);
        assertNull(LightBufferBuilder.build(other, hulls, lamp(false, new Vector(0, 3e6, 0))));
        assertNotNull(LightBufferBuilder.build(other, hulls, lamp(false, new Vector(0, 3, 0))));
    }

    @Test
    void isNotBuiltOfASingleLeaf() {
        List<Shape.Sphere> one = List.of(new Shape.Sphere(ORIGIN, 1, Material.DEFAULT));
        Bvh bvh = BvhBuilder.build(1, Spheres.bounds(one), Spheres.LEAF_SIZE, ForkJoinPool.commonPool());
        assertNull(LightBufferBuilder.build(bvh, shapes(bvh, one), lamp(false, new Vector(0, 3, 0))));
        assertNull(LightBufferBuilder.build(bvh, shapes(bvh, one), lamp(true, new Vector(0, 1, 0))));
    }

    @Test
    void isNotUsedByRaysThatStartFartherAwayThanDoublesReach() {
        List<Shape.Sphere> spheres = spheres(new Random(7), ORIGIN, .05);
        Bvh bvh = tree(spheres);
        LightBuffer buffer = LightBufferBuilder.build(
                bvh, shapes(bvh, spheres), lamp(false, new Vector(0, 3, 0)));
        Rays rays = new Rays();
        rays.oy[1] = -3e6;
        assertTrue(buffer.isNearEnough(rays, 0, 1));
        assertFalse(buffer.isNearEnough(rays, 0, 2));
    }

    @Test
    void isBuiltIfMoreWalksAreToComeThanItCosts() {
        List<Shape.Sphere> spheres = spheres(new Random(5), ORIGIN, .05);
        Bvh bvh = tree(spheres);
        LightSource lamp = lamp(false, new Vector(0, 3, 0));
        // Building costs a walk for each of 500 primitives, and 250,000 as long as its code is cold.
        for (int ahead : new int[] {250_000, 251_000}) {
            Progress progress = new Progress();
            progress.expect(1000 + ahead);
            progress.add(1000);
            LazyLightBuffer lazy = new Viewpoints(List.of(lamp), progress)
                    .buffers(bvh, shapes(bvh, spheres)).get(lamp);
            assertNull(lazy.insteadOfWalks(30), "too few walks to tell");
            LightBuffer built = lazy.insteadOfWalks(970);
            assertEquals(ahead == 251_000, built != null, ahead + " walks ahead");
            assertEquals(built, lazy.ifBuilt());
        }
    }

    @Test
    void isNotBuiltWithoutTheMemoryForIt() {
        // 140 bytes for each of 2,000,000 things, and a quarter of 1 GB for all else.
        long most = 1_000_000_000, needed = 280_000_000 + most / 4;
        assertFalse(LazyLightBuffer.hasRoom(2_000_000, most, most - needed));
        assertTrue(LazyLightBuffer.hasRoom(2_000_000, most, most - needed - 1));
    }

    /** @param viewpoints that are to have buffers */
    public static List<Surfaces> surfaces(List<Shape.Sphere> spheres, Mesh mesh, Viewpoints viewpoints) {
        Bvh curved = tree(spheres), flat = tree(mesh);
        return List.of(new Spheres(inOrder(curved, spheres), 0, curved, viewpoints),
                new Triangles(mesh, COUNT, flat, viewpoints, ForkJoinPool.commonPool()));
    }

    @ParameterizedTest(name = "blocks the same rays as the tree, from the moment that it is built: directional {0}")
    @CsvSource({"false", "true"})
    void blocksTheSameRaysAsTheTree(boolean directional) {
        Random random = new Random(6);
        LightSource lamp = lamp(directional, directional ? new Vector(1, 2, -.3).unit() : new Vector(1, 2, -.3));
        List<Shape.Sphere> spheres = spheres(random, ORIGIN, .06);
        Mesh mesh = triangles(random, ORIGIN, .1);
        List<Surfaces> with = surfaces(spheres, mesh, viewpoints(lamp)), without = surfaces(spheres, mesh, NONE);
        int blocked = 0;
        SearchWorkspace space = new SearchWorkspace();
        for (int tile = 0; tile < 600; tile++) {
            Rays rays = start(random, with);
            ShadowRays a = blocked(rays, with.get(tile % 2), lamp, space);
            ShadowRays b = blocked(rays, without.get(tile % 2), lamp, space);
            assertTrue(Arrays.equals(a.unoccluded, b.unoccluded), "tile " + tile);
            blocked += IntStream.range(0, Batch.CAPACITY).map(i -> a.unoccluded[i] ? 0 : 1).sum();
        }
        assertTrue(blocked > 10_000 && blocked < 590 * Batch.CAPACITY, blocked + " blocked");
        with.forEach(kind -> assertNotNull(((BoundedSurfaces) kind).lightBuffer(lamp).ifBuilt(), "it was built"));
    }

    @Test
    void isNoHindranceToRaysThatStartTooFarAwayForIt() {
        Random random = new Random(8);
        List<Shape.Sphere> spheres = spheres(random, ORIGIN, .06);
        Bvh bvh = tree(spheres);
        Vector light = new Vector(0, 3, 0);
        LightSource lamp = lamp(false, light);
        Spheres with = new Spheres(inOrder(bvh, spheres), 0, bvh, viewpoints(lamp));
        Spheres without = new Spheres(inOrder(bvh, spheres), 0, bvh, NONE);
        SearchWorkspace space = new SearchWorkspace();
        for (int tile = 0; tile < 200; tile++) {
            blocked(start(random, List.of(with)), with, lamp, space);
        }
        int blocked = 0;
        for (int tile = 0; tile < 50; tile++) {
            // A beam has looked elsewhere last.
            Rays near = around(plus(light, 2, within(random, 1).minus(light)), .2, random, List.of(with));
            near.leaveEye = true;
            blocked(near, with, lamp, space);
            Rays far = around(plus(light, 3e6, within(random, 1).minus(light)), 1e5, random, List.of(with));
            ShadowRays a = blocked(far, with, lamp, space);
            ShadowRays b = blocked(far, without, lamp, new SearchWorkspace());
            assertTrue(Arrays.equals(a.unoccluded, b.unoccluded), "tile " + tile);
            blocked += IntStream.range(0, Batch.CAPACITY).map(i -> a.unoccluded[i] ? 0 : 1).sum();
        }
        assertTrue(blocked > 1000, blocked + " blocked");
    }

    private static Rays around(Vector middle, double size, Random random, List<Surfaces> surfaces) {
        Rays rays = start(random, surfaces);
        for (int i = 0; i < Batch.CAPACITY; i++) {
            Vector place = plus(middle, 1, within(random, size));
            rays.ox[i] = place.x();
            rays.oy[i] = place.y();
            rays.oz[i] = place.z();
        }
        return rays;
    }

    /** Rays that have arrived all over the place. */
    private static Rays start(Random random, List<Surfaces> surfaces) {
        Rays rays = new Rays();
        rays.count = Batch.CAPACITY;
        for (int i = 0; i < Batch.CAPACITY; i++) {
            rays.ox[i] = coordinate(random, 1.5);
            rays.oy[i] = coordinate(random, 1.5);
            rays.oz[i] = coordinate(random, 1.5);
            rays.hit[i] = Rays.NONE;
        }
        return rays;
    }

    private static ShadowRays blocked(Rays rays, Surfaces surfaces, LightSource lamp, SearchWorkspace space) {
        ShadowRays shadows = new ShadowRays(rays);
        shadows.start(0, Batch.CAPACITY);
        shadows.aim(lamp, 0, Batch.CAPACITY);
        Arrays.fill(shadows.unoccluded, true);
        AnyHit.among(surfaces, rays, shadows, space).run(0, Batch.CAPACITY);
        return shadows;
    }
}
