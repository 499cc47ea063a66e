package raytracer.tracer;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracer.parser.Scenes;
import raytracer.scene.Mesh;
import raytracer.scene.Shape;
import raytracer.tracer.kernel.Batch;
import raytracer.tracer.lightbuffer.LightBufferTest;
import raytracer.tracer.surface.BoundedSurfaces;
import raytracer.tracer.surface.Surfaces;
import raytracer.tracer.rays.Rays;
import raytracer.tracer.rays.Samples;
import raytracer.tracer.search.ClosestHit;
import raytracer.tracer.search.SearchWorkspace;

@DisplayName("A light buffer of the eye")
class EyeBufferTest {

    @ParameterizedTest(name = "shows the eye what the tree shows: {0}, world of size {1}")
    @CsvSource({"3 2 4 0 0 0 0 1 0 40, 1", "0 0 3 .3 .2 0 0 1 0 90, 1", "0 .9 0 0 0 .1 0 1 0 150, 1",
        "0 0 0 1 .1 .2 0 1 0 100, 1", "-5e3 1e3 0 0 0 0 0 0 1 .03, 1", "2 2 2 0 0 0 0 0 1 60, 1",
        "3e-4 2e-4 4e-4 0 0 0 0 1 0 40, 1e-4", "3e7 2e7 4e7 0 0 0 0 1 0 40, 1e7"})
    void showsTheEyeWhatTheTreeShows(String camera, double size) throws Exception {
        Random random = new Random(9);
        Pinhole pinhole = new Pinhole(Scenes.parse("size 48 48\ncamera " + camera + "\nsphere 0 0 0 1").scene());
        List<Shape.Sphere> spheres = LightBufferTest.spheres(random, LightBufferTest.ORIGIN, .06).stream()
                .map(s -> new Shape.Sphere(s.centre().times(size), s.radius() * size, s.material())).toList();
        Mesh mesh = LightBufferTest.scaled(LightBufferTest.triangles(random, LightBufferTest.ORIGIN, .1), size);
        List<Surfaces> with = LightBufferTest.surfaces(spheres, mesh, LightBufferTest.viewpoints(pinhole.viewpoint()));
        List<Surfaces> without = LightBufferTest.surfaces(spheres, mesh, LightBufferTest.NONE);
        for (Surfaces kind : with) {
            assertNotNull(((BoundedSurfaces) kind).lightBuffer(pinhole.source()).insteadOfWalks(300_000));
        }
        int met = 0;
        int lookedUp = 0;
        // A rim of a pixel is looked at too.
        for (int pixel = 0; pixel < 50 * 50; pixel += Batch.CAPACITY / 4) {
            SearchWorkspace space = new SearchWorkspace();
            Rays a = seen(pinhole, pixel, with, space), b = seen(pinhole, pixel, without, new SearchWorkspace());
            assertTrue(Arrays.equals(a.hit, b.hit), "pixel " + pixel);
            assertTrue(Arrays.equals(a.distance, b.distance), "pixel " + pixel);
            met += Arrays.stream(a.hit).map(slot -> slot == Rays.NONE ? 0 : 1).sum();
            lookedUp += IntStream.range(0, Batch.CAPACITY).map(i -> space.cells().end[i] > 0 ? 1 : 0).sum();
        }
        assertTrue(met > 500 && lookedUp > 1000, met + " met, " + lookedUp + " looked up");
    }

    /** What the eye sees in a quarter of a tile's pixels, in rows of 50, by 2 x 2 samples. */
    private static Rays seen(Pinhole pinhole, int pixel, List<Surfaces> surfaces, SearchWorkspace space) {
        Samples samples = new Samples();
        for (int i = 0; i < Batch.CAPACITY; i++) {
            int p = pixel + i / 4;
            SamplesTest.add(samples, p % 50 - 1 + .25 + i % 2 * .5, p / 50 - 1 + .25 + i % 4 / 2 * .5);
        }
        Rays rays = new Rays();
        rays.start(pinhole.aiming(rays), samples, 0, Batch.CAPACITY);
        rays.clearHits();
        surfaces.forEach(kind -> ClosestHit.among(kind, rays, pinhole.source(), space).run(0, Batch.CAPACITY));
        return rays;
    }
}
