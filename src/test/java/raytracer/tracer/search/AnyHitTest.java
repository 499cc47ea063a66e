package raytracer.tracer.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.scene.Colour;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Shape;
import raytracer.scene.Vector;
import raytracer.tracer.arithmetic.Batch;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.primitive.SphereBounds;
import raytracer.tracer.primitive.Spheres;
import raytracer.tracer.primitive.TriangleBounds;
import raytracer.tracer.primitive.Triangles;
import raytracer.tracer.rays.LightSource;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.ShadowRays;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.surface.Workspace;

/** The search for any hit. */
class AnyHitTest {

    private static final int COUNT = 500;
    private static final int TILES = 60;

    private final Random random = new Random(6);

    private Vector within(double size) {
        return new Vector(size * (2 * random.nextDouble() - 1), size * (2 * random.nextDouble() - 1),
                size * (2 * random.nextDouble() - 1));
    }

    private static Vector plus(Vector a, Vector b) {
        return new Vector(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
    }

    private Surfaces spheres() {
        List<Shape.Sphere> spheres = new ArrayList<>();
        for (int k = 0; k < COUNT; k++) {
            spheres.add(new Shape.Sphere(within(1), .06 * (.1 + random.nextDouble()), new Material(Colour.BLACK, Colour.BLACK, Colour.BLACK, 1)));
        }
        Bvh bvh = BvhBuilder.build(COUNT, new SphereBounds(spheres), Spheres.LEAF_SIZE);
        return new Spheres(Arrays.stream(bvh.order()).mapToObj(spheres::get).toList(), 0, bvh);
    }

    private Surfaces triangles() {
        Mesh.Builder mesh = new Mesh.Builder();
        for (int k = 0; k < COUNT; k++) {
            Vector place = within(1);
            for (int corner = 0; corner < 3; corner++) {
                Vector v = plus(place, within(.15));
                mesh.addVertex(v.x(), v.y(), v.z());
            }
            mesh.addTriangle(3 * k, 3 * k + 1, 3 * k + 2);
        }
        Mesh all = mesh.build();
        Bvh bvh = BvhBuilder.build(COUNT, new TriangleBounds(all), Triangles.LEAF_SIZE);
        return new Triangles(all, 0, bvh);
    }

    @ParameterizedTest(name = "finds what trying each surface finds: points within {0}, directional light: {1}")
    @CsvSource({"1.5, false", "1.5, true", ".2, false", ".2, true", ".01, false", ".01, true"})
    void findsWhatTryingEachFinds(double size, boolean directional) {
        Vector v = directional ? new Vector(1, 2, -.3).unit() : new Vector(1, 2, -.3);
        LightSource light = new LightSource(directional, v.x(), v.y(), v.z(), Colour.BLACK);
        for (Surfaces surfaces : List.of(spheres(), triangles())) {
            Rays rays = new Rays();
            ShadowRays shadows = new ShadowRays(rays);
            // One object for all tiles: what it remembers of one must not matter to the next.
            var search = AnyHit.among(surfaces, rays, shadows, new Workspace());
            int blocked = 0;
            for (int tile = 0; tile < TILES; tile++) {
                scatter(rays, within(1.2), size);
                shadows.start(0, Batch.CAPACITY);
                shadows.aim(light, 0, Batch.CAPACITY);
                Arrays.fill(shadows.unoccluded, true);
                search.run(0, Batch.CAPACITY);
                for (int i = 0; i < Batch.CAPACITY; i++) {
                    int ray = i;
                    boolean isBlocked = IntStream.range(0, COUNT).anyMatch(k -> surfaces.blocks(rays, shadows, ray, k));
                    assertEquals(!isBlocked, shadows.unoccluded[i], "tile " + tile + ", ray " + i);
                    blocked += isBlocked ? 1 : 0;
                }
            }
            assertTrue(blocked > TILES * Batch.CAPACITY / 20 && blocked < TILES * Batch.CAPACITY * .95, blocked + " blocked");
        }
    }

    private void scatter(Rays rays, Vector about, double size) {
        rays.count = Batch.CAPACITY;
        for (int i = 0; i < Batch.CAPACITY; i++) {
            Vector from = plus(about, within(size));
            rays.ox[i] = from.x();
            rays.oy[i] = from.y();
            rays.oz[i] = from.z();
            rays.hit[i] = Rays.NONE;
        }
    }
}
