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
import raytracer.tracer.lightbuffer.Viewpoint;
import raytracer.tracer.primitive.Planes;
import raytracer.tracer.primitive.SurfaceTable;
import raytracer.tracer.primitive.Spheres;
import raytracer.tracer.primitive.Surfaces;
import raytracer.tracer.primitive.Triangles;

/** Sorts a scene's shapes by kind and gives each surface its slot: planes first, then spheres, then triangles. */
final class SurfaceCompiler {

    private final List<Viewpoint> viewpoints;
    private final Mesh mesh;
    private final ForkJoinPool pool;
    private final int[] declaredBySlot;
    private final int[] lookBySlot;
    private final List<Material> looks = new ArrayList<>();

    private final List<Shape.Plane> planes = new ArrayList<>();
    private final List<Shape.Sphere> spheres = new ArrayList<>();

    // By number among the shapes of its kind: what goes to the slot table.
    private final Origins planeOrigins;
    private final Origins sphereOrigins;
    private final Origins triangleOrigins;

    /** Where surfaces of one kind come from, in the order of declaration. */
    private static final class Origins {
        final int[] declared;
        final Material[] material;
        final Map<Material, Integer> lookOf = new HashMap<>();
        int count;
        private Material last;
        private int lastLook;

        Origins(int most) {
            declared = new int[most];
            material = new Material[most];
        }

        void add(int number, Material made) {
            declared[count] = number;
            material[count++] = made;
        }

        /** The number of this kind's look with a surface's material, which it gets if it has none yet. */
        int look(int number, List<Material> looks) {
            Material made = material[number];
            if (made != last) {
                last = made;
                Integer known = lookOf.putIfAbsent(made, looks.size());
                if (known == null) {
                    looks.add(made);
                }
                lastLook = known == null ? looks.size() - 1 : known;
            }
            return lastLook;
        }
    }

    SurfaceCompiler(Scene scene, List<Viewpoint> viewpoints, ForkJoinPool pool) {
        this.viewpoints = viewpoints;
        this.mesh = scene.mesh();
        this.pool = pool;
        planeOrigins = new Origins(count(scene.shapes(), Shape.Plane.class));
        sphereOrigins = new Origins(count(scene.shapes(), Shape.Sphere.class));
        triangleOrigins = new Origins(mesh.triangles());
        int declared = 0;
        for (Shape shape : scene.shapes()) {
            sort(shape, declared);
            declared = Math.addExact(declared, shape.count());
        }
        declaredBySlot = new int[planes.size() + spheres.size() + mesh.triangles()];
        lookBySlot = new int[declaredBySlot.length];
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
    SurfaceTable slots() {
        return new SurfaceTable(declaredBySlot, lookBySlot, looks.toArray(new Material[0]));
    }

    private Surfaces planes() {
        for (int k = 0; k < planes.size(); k++) {
            settle(k, planeOrigins, k);
        }
        return new Planes(planes, 0);
    }

    private Surfaces spheres() {
        Bvh bvh = BvhBuilder.build(spheres.size(), Spheres.bounds(spheres), Spheres.LEAF_SIZE, pool);
        int firstSlot = planes.size();
        List<Shape.Sphere> ordered = new ArrayList<>(spheres.size());
        for (int k = 0; k < spheres.size(); k++) {
            ordered.add(spheres.get(bvh.order()[k]));
            settle(firstSlot + k, sphereOrigins, bvh.order()[k]);
        }
        return new Spheres(ordered, firstSlot, bvh, viewpoints);
    }

    private Surfaces triangles() {
        Bvh bvh = BvhBuilder.build(mesh.triangles(), Triangles.bounds(mesh), Triangles.LEAF_SIZE, pool);
        int firstSlot = planes.size() + spheres.size();
        for (int k = 0; k < mesh.triangles(); k++) {
            settle(firstSlot + k, triangleOrigins, bvh.order()[k]);
        }
        return new Triangles(mesh, firstSlot, bvh, viewpoints, pool);
    }

    private void settle(int slot, Origins from, int k) {
        declaredBySlot[slot] = from.declared[k];
        lookBySlot[slot] = from.look(k, looks);
    }
}
