package raytracer.tracer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import raytracer.scene.Material;
import raytracer.scene.Mesh;
import raytracer.scene.Scene;
import raytracer.scene.Shape;
import raytracer.tracer.bvh.Bvh;
import raytracer.tracer.bvh.BvhBuilder;
import raytracer.tracer.primitive.Planes;
import raytracer.tracer.primitive.SphereBounds;
import raytracer.tracer.primitive.Spheres;
import raytracer.tracer.primitive.TriangleBounds;
import raytracer.tracer.primitive.Triangles;
import raytracer.tracer.surface.SurfaceTable;
import raytracer.tracer.surface.Surfaces;

/** Sorts a scene's shapes by kind and gives each surface its index: planes first, then spheres, then triangles. */
final class SurfaceCompiler {

    private final Mesh mesh;
    private final List<Shape.Plane> planes = new ArrayList<>();
    private final List<Shape.Sphere> spheres = new ArrayList<>();

    // What becomes the surface table. Until a kind's tree is built, its surfaces are in the order of declaration.
    private final int[] declared;
    private final int[] materialIndex;
    private final List<Material> materials = new ArrayList<>();

    SurfaceCompiler(Scene scene) {
        mesh = scene.mesh();
        int count = 0;
        for (Shape shape : scene.shapes()) {
            count = Math.addExact(count, shape.count());
            if (shape instanceof Shape.Plane plane) {
                planes.add(plane);
            } else if (shape instanceof Shape.Sphere sphere) {
                spheres.add(sphere);
            }
        }
        declared = new int[count];
        materialIndex = new int[count];
        list(scene.shapes(), Shape.Plane.class, 0);
        list(scene.shapes(), Shape.Sphere.class, planes.size());
        list(scene.shapes(), Shape.Triangles.class, planes.size() + spheres.size());
    }

    /** Lists the surfaces of one kind, which begin at some index. */
    private void list(List<Shape> shapes, Class<? extends Shape> kind, int first) {
        Map<Material, Integer> indices = new HashMap<>();
        int surface = first, number = 0;
        for (Shape shape : shapes) {
            if (kind.isInstance(shape)) {
                Integer known = indices.putIfAbsent(shape.material(), materials.size());
                if (known == null) {
                    materials.add(shape.material());
                }
                Arrays.fill(materialIndex, surface, surface + shape.count(), known == null ? materials.size() - 1 : known);
                for (int k = 0; k < shape.count(); k++) {
                    declared[surface++] = number + k;
                }
            }
            number += shape.count();
        }
    }

    /** Makes the kinds that the scene has. */
    List<Surfaces> surfaces() {
        List<Surfaces> kinds = new ArrayList<>();
        if (!planes.isEmpty()) {
            kinds.add(new Planes(planes, 0));
        }
        if (!spheres.isEmpty()) {
            kinds.add(spheres(planes.size()));
        }
        if (mesh.triangles() > 0) {
            kinds.add(triangles(planes.size() + spheres.size()));
        }
        return List.copyOf(kinds);
    }

    /** Complete when the surfaces have been made. */
    SurfaceTable table() {
        return new SurfaceTable(declared, materialIndex, materials.toArray(new Material[0]));
    }

    private Surfaces spheres(int first) {
        Bvh bvh = BvhBuilder.build(spheres.size(), new SphereBounds(spheres), Spheres.LEAF_SIZE);
        arrange(first, bvh.order());
        return new Spheres(Arrays.stream(bvh.order()).mapToObj(spheres::get).toList(), first, bvh);
    }

    private Surfaces triangles(int first) {
        Bvh bvh = BvhBuilder.build(mesh.triangles(), new TriangleBounds(mesh), Triangles.LEAF_SIZE);
        arrange(first, bvh.order());
        return new Triangles(mesh, first, bvh);
    }

    /** Puts surfaces in the order of their tree. */
    private void arrange(int first, int[] order) {
        int[] declaredBefore = Arrays.copyOfRange(declared, first, first + order.length);
        int[] materialBefore = Arrays.copyOfRange(materialIndex, first, first + order.length);
        for (int k = 0; k < order.length; k++) {
            declared[first + k] = declaredBefore[order[k]];
            materialIndex[first + k] = materialBefore[order[k]];
        }
    }
}
