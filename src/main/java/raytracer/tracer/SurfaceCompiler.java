package raytracer.tracer;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ForkJoinPool;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.primitive.Planes;
import raytracer.tracer.primitive.Spheres;
import raytracer.tracer.primitive.Triangles;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;

/** Sorts a scene's shapes by kind and gives each surface its index: planes first, then spheres, then triangles. */
final class SurfaceCompiler {

    private final Mesh mesh;
    private final ForkJoinPool pool;
    private final int[] declared;
    private final int[] materialIndex;
    private final List<Material> materials = new ArrayList<>();

    private final List<Shape.Plane> planes = new ArrayList<>();
    private final List<Shape.Sphere> spheres = new ArrayList<>();

    // By number among the shapes of its kind: what goes into the surface table.
    private final Origins planeOrigins;
    private final Origins sphereOrigins;
    private final Origins triangleOrigins;

    /** Where surfaces of one kind come from, in the order of declaration. */
    private static final class Origins {
        final int[] declared;
        final Material[] material;
        final Map<Material, Integer> materialOf = new HashMap<>();
        int count;
        private Material last;
        private int lastIndex;

        Origins(int max) {
            declared = new int[max];
            material = new Material[max];
        }

        void add(int number, Material made) {
            declared[count] = number;
            material[count++] = made;
        }

        /** The index of a surface's material among those of this kind. */
        int materialIndex(int number, List<Material> materials) {
            Material made = material[number];
            if (made != last) {
                last = made;
                Integer known = materialOf.putIfAbsent(made, materials.size());
                if (known == null) {
                    materials.add(made);
                }
                lastIndex = known == null ? materials.size() - 1 : known;
            }
            return lastIndex;
        }
    }

    SurfaceCompiler(Scene scene, ForkJoinPool pool) {
        this.mesh = scene.mesh();
        this.pool = pool;
        planeOrigins = new Origins(count(scene.shapes(), Shape.Plane.class));
        sphereOrigins = new Origins(count(scene.shapes(), Shape.Sphere.class));
        triangleOrigins = new Origins(mesh.triangles());
        int next = 0;
        for (Shape shape : scene.shapes()) {
            sort(shape, next);
            next = Math.addExact(next, shape.count());
        }
        declared = new int[planes.size() + spheres.size() + mesh.triangles()];
        materialIndex = new int[declared.length];
    }

    private static int count(List<Shape> shapes, Class<? extends Shape> kind) {
        int count = 0;
        for (Shape shape : shapes) {
            count += kind.isInstance(shape) ? 1 : 0;
        }
        return count;
    }

    private void sort(Shape shape, int declared) {
        if (shape instanceof Shape.Plane plane) {
            planes.add(plane);
            planeOrigins.add(declared, plane.material());
        } else if (shape instanceof Shape.Sphere sphere) {
            spheres.add(sphere);
            sphereOrigins.add(declared, sphere.material());
        } else if (shape instanceof Shape.Triangles run) {
            for (int k = 0; k < run.count(); k++) {
                triangleOrigins.add(declared + k, run.material());
            }
        }
    }

    /** Makes the kinds that the scene has. */
    List<Surfaces> surfaces() {
        List<Surfaces> kinds = new ArrayList<>();
        if (!planes.isEmpty()) {
            kinds.add(planes());
        }
        if (!spheres.isEmpty()) {
            kinds.add(spheres());
        }
        if (mesh.triangles() > 0) {
            kinds.add(triangles());
        }
        return List.copyOf(kinds);
    }

    /** Complete when the surfaces have been made. */
    SurfaceTable table() {
        return new SurfaceTable(declared, materialIndex, materials.toArray(new Material[0]));
    }

    private Surfaces planes() {
        for (int k = 0; k < planes.size(); k++) {
            settle(k, planeOrigins, k);
        }
        return new Planes(planes, 0);
    }

    private Surfaces spheres() {
        Bvh bvh = BvhBuilder.build(spheres.size(), Spheres.bounds(spheres), Spheres.LEAF_SIZE, pool);
        int firstSurface = planes.size();
        List<Shape.Sphere> ordered = new ArrayList<>(spheres.size());
        for (int k = 0; k < spheres.size(); k++) {
            ordered.add(spheres.get(bvh.order()[k]));
            settle(firstSurface + k, sphereOrigins, bvh.order()[k]);
        }
        return new Spheres(ordered, firstSurface, bvh);
    }

    private Surfaces triangles() {
        Bvh bvh = BvhBuilder.build(mesh.triangles(), Triangles.bounds(mesh), Triangles.LEAF_SIZE, pool);
        int firstSurface = planes.size() + spheres.size();
        for (int k = 0; k < mesh.triangles(); k++) {
            settle(firstSurface + k, triangleOrigins, bvh.order()[k]);
        }
        return new Triangles(mesh, firstSurface, bvh, pool);
    }

    private void settle(int surface, Origins from, int k) {
        declared[surface] = from.declared[k];
        materialIndex[surface] = from.materialIndex(k, materials);
    }
}
