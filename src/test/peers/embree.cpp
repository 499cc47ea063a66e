// The same pictures by Embree 3, in float: one ray at a time, or sixteen in a packet, the way its makers use it.
// usage: embree SCENE OUT.ppm SAMPLES-ALONG-A-PIXEL'S-SIDE ray|packet
// g++ -O3 -march=native -o embree embree.cpp -lembree3 -lpthread, with Debian's libembree-dev.
#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

struct Vec { float x, y, z; };
static Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Vec operator*(Vec a, float f) { return {a.x * f, a.y * f, a.z * f}; }
static Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
static float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }

struct Material { Vec ambient{0, 0, 0}, diffuse{0, 0, 0}, specular{0, 0, 0}; float shininess = 1; };
struct Plane { Vec point, normal; int material; };
struct Light { bool directional; Vec place, colour; };

static const float FAR = 1e30f;
static const int PACKET = 16, TILE = 16;

struct Scene {
    int width = 0, height = 0, maxDepth = 1;
    Vec eye, at, up;
    float fov = 0;
    std::vector<Material> materials{Material()};
    std::vector<Plane> planes;
    std::vector<Light> lights;
    std::vector<Vec> vertices;
    std::vector<unsigned> corners;
    std::vector<float> spheres;
    std::vector<int> materialOfTriangle, materialOfSphere;
    RTCScene embree = nullptr;
    unsigned triangleGeometry = RTC_INVALID_GEOMETRY_ID;
};

static Scene read(const char *file) {
    Scene s;
    std::ifstream in(file);
    bool used = false;
    auto current = [&]() -> Material & {
        if (used) s.materials.push_back(s.materials.back());
        used = false;
        return s.materials.back();
    };
    auto material = [&] { used = true; return (int) s.materials.size() - 1; };
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string command;
        if (!(words >> command)) continue;
        auto number = [&] { std::string w; words >> w; return std::strtof(w.c_str(), nullptr); };
        auto vector = [&] { float x = number(), y = number(), z = number(); return Vec{x, y, z}; };
        if (command == "size") { s.width = number(); s.height = number(); }
        else if (command == "camera") { s.eye = vector(); s.at = vector(); s.up = vector(); s.fov = number(); }
        else if (command == "maxdepth") s.maxDepth = number();
        else if (command == "ambient") current().ambient = vector();
        else if (command == "diffuse") current().diffuse = vector();
        else if (command == "specular") current().specular = vector();
        else if (command == "shininess") current().shininess = number();
        else if (command == "point" || command == "directional") {
            Vec place = vector(), colour = vector();
            s.lights.push_back({command == "directional", place, colour});
        } else if (command == "vertex") s.vertices.push_back(vector());
        else if (command == "sphere") {
            for (int i = 0; i < 4; i++) s.spheres.push_back(number());
            s.materialOfSphere.push_back(material());
        } else if (command == "plane") {
            Vec point = vector(), normal = vector();
            s.planes.push_back({point, unit(normal), material()});
        } else if (command == "tri") {
            for (int i = 0; i < 3; i++) s.corners.push_back(number());
            s.materialOfTriangle.push_back(material());
        }
    }
    return s;
}

static void *buffer(RTCGeometry g, RTCBufferType type, RTCFormat format, size_t size, size_t count, const void *from) {
    void *to = rtcSetNewGeometryBuffer(g, type, 0, format, size, count);
    return std::memcpy(to, from, size * count);
}

static unsigned attach(RTCScene scene, RTCGeometry g) {
    rtcCommitGeometry(g);
    return rtcAttachGeometry(scene, g);
}

static void build(Scene &s) {
    RTCDevice device = rtcNewDevice(nullptr);
    s.embree = rtcNewScene(device);
    if (!s.corners.empty()) {
        RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        buffer(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, s.vertices.size(), s.vertices.data());
        buffer(g, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 12, s.corners.size() / 3, s.corners.data());
        s.triangleGeometry = attach(s.embree, g);
    }
    if (!s.spheres.empty()) {
        RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        buffer(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, s.spheres.size() / 4, s.spheres.data());
        attach(s.embree, g);
    }
    rtcCommitScene(s.embree);
}

// A path: where it is, where it goes, how much of its light reaches the pixel, and the light so far.
struct Path { Vec origin, direction, weight, light; bool alive; };
struct Hit { Vec point, normal; const Material *material; };

static float onPlane(const Plane &p, Vec o, Vec d) {
    float cosine = dot(d, p.normal), t = dot(p.point - o, p.normal) / cosine;
    return cosine != 0 && t > 1e-4f ? t : FAR;
}

// The nearest of what Embree has found and the planes; false if there is none.
static bool closest(const Scene &s, const Path &path, float t, unsigned geometry, unsigned primitive, Vec normal, Hit &hit) {
    int plane = -1;
    for (size_t i = 0; i < s.planes.size(); i++) {
        float there = onPlane(s.planes[i], path.origin, path.direction);
        if (there < t) { t = there; plane = i; }
    }
    if (plane < 0 && geometry == RTC_INVALID_GEOMETRY_ID) return false;
    hit.normal = plane >= 0 ? s.planes[plane].normal : unit(normal);
    hit.material = &s.materials[plane >= 0 ? s.planes[plane].material
            : geometry == s.triangleGeometry ? s.materialOfTriangle[primitive] : s.materialOfSphere[primitive]];
    Vec p = path.origin + path.direction * t;
    // Off the surface, to the side where the ray comes from, by about what float rounds.
    float off = 1e-5f * (1 + std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}));
    hit.point = p + hit.normal * (dot(hit.normal, path.direction) < 0 ? off : -off);
    return true;
}

static bool planeBlocks(const Scene &s, Vec from, Vec towards, float distance) {
    for (const Plane &p : s.planes) if (onPlane(p, from, towards) < distance) return true;
    return false;
}

static Vec towards(const Light &light, Vec point, float &distance) {
    Vec way = light.directional ? light.place : light.place - point;
    distance = light.directional ? FAR : std::sqrt(dot(way, way));
    return unit(way);
}

static Vec lit(const Light &light, const Hit &hit, Vec towardsLight, Vec direction) {
    float lambert = std::max(0.f, dot(hit.normal, towardsLight));
    float highlight = std::max(0.f, dot(hit.normal, unit(towardsLight - direction)));
    const Material &m = *hit.material;
    return light.colour * (m.diffuse * lambert + m.specular * std::pow(highlight, m.shininess));
}

// Adds what a hit gives, and turns the path into its mirror image if there is one.
static void bounce(Path &path, const Hit &hit, Vec light, bool last) {
    path.light = path.light + path.weight * light;
    Vec mirror = hit.material->specular;
    path.alive = !last && (mirror.x > 0 || mirror.y > 0 || mirror.z > 0);
    path.weight = path.weight * mirror;
    path.origin = hit.point;
    path.direction = unit(path.direction - hit.normal * (2 * dot(hit.normal, path.direction)));
}

static void traceOne(const Scene &s, Path &path) {
    for (int depth = 1; path.alive; depth++) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r{};
        Vec o = path.origin, d = path.direction;
        r.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, FAR, ~0u, 0, 0};
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(s.embree, &context, &r);
        Hit hit;
        if (!closest(s, path, r.ray.tfar, r.hit.geomID, r.hit.primID, {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z}, hit)) return;
        Vec sum = hit.material->ambient, p = hit.point;
        for (const Light &light : s.lights) {
            float distance;
            Vec l = towards(light, p, distance);
            if (planeBlocks(s, p, l, distance)) continue;
            RTCRay shadow{p.x, p.y, p.z, 0, l.x, l.y, l.z, 0, distance, ~0u, 0, 0};
            rtcOccluded1(s.embree, &context, &shadow);
            if (shadow.tfar >= 0) sum = sum + lit(light, hit, l, d);
        }
        bounce(path, hit, sum, depth == s.maxDepth);
    }
}

static void traceSixteen(const Scene &s, Path *paths) {
    alignas(64) int valid[PACKET], asks[PACKET];
    alignas(64) RTCRayHit16 r;
    alignas(64) RTCRay16 shadow;
    Hit hit[PACKET];
    Vec sum[PACKET], l[PACKET];
    for (int depth = 1; depth <= s.maxDepth; depth++) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = depth == 1 ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        bool any = false;
        for (int i = 0; i < PACKET; i++) {
            valid[i] = paths[i].alive ? -1 : 0;
            any |= paths[i].alive;
            Vec o = paths[i].origin, d = paths[i].direction;
            r.ray.org_x[i] = o.x; r.ray.org_y[i] = o.y; r.ray.org_z[i] = o.z;
            r.ray.dir_x[i] = d.x; r.ray.dir_y[i] = d.y; r.ray.dir_z[i] = d.z;
            r.ray.tnear[i] = 0; r.ray.tfar[i] = FAR; r.ray.time[i] = 0; r.ray.mask[i] = ~0u; r.ray.flags[i] = 0;
            r.hit.geomID[i] = r.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        if (!any) return;
        rtcIntersect16(valid, s.embree, &context, &r);
        for (int i = 0; i < PACKET; i++) {
            Vec normal{r.hit.Ng_x[i], r.hit.Ng_y[i], r.hit.Ng_z[i]};
            if (paths[i].alive) {
                paths[i].alive = closest(s, paths[i], r.ray.tfar[i], r.hit.geomID[i], r.hit.primID[i], normal, hit[i]);
            }
            if (paths[i].alive) sum[i] = hit[i].material->ambient;
        }
        for (const Light &light : s.lights) {
            for (int i = 0; i < PACKET; i++) {
                asks[i] = 0;
                if (!paths[i].alive) continue;
                float distance;
                Vec p = hit[i].point;
                l[i] = towards(light, p, distance);
                asks[i] = planeBlocks(s, p, l[i], distance) ? 0 : -1;
                shadow.org_x[i] = p.x; shadow.org_y[i] = p.y; shadow.org_z[i] = p.z;
                shadow.dir_x[i] = l[i].x; shadow.dir_y[i] = l[i].y; shadow.dir_z[i] = l[i].z;
                shadow.tnear[i] = 0; shadow.tfar[i] = distance;
                shadow.time[i] = 0; shadow.mask[i] = ~0u; shadow.flags[i] = 0;
            }
            rtcOccluded16(asks, s.embree, &context, &shadow);
            for (int i = 0; i < PACKET; i++) {
                if (asks[i] && shadow.tfar[i] >= 0) sum[i] = sum[i] + lit(light, hit[i], l[i], paths[i].direction);
            }
        }
        for (int i = 0; i < PACKET; i++) {
            if (paths[i].alive) bounce(paths[i], hit[i], sum[i], depth == s.maxDepth);
        }
    }
}

struct Picture {
    const Scene &s;
    int samples;
    bool packets;
    Vec right, up, backward;
    std::vector<unsigned char> bytes;
    std::atomic<int> next{0};

    Picture(const Scene &scene, int samples, bool packets)
            : s(scene), samples(samples), packets(packets), bytes(3 * (size_t) s.width * s.height) {
        float half = std::tan(s.fov * (float) M_PI / 360);
        backward = unit(s.eye - s.at);
        Vec u = unit(cross(s.up, backward));
        right = u * half;
        up = cross(backward, u) * half;
    }

    Path through(float x, float y) const {
        float a = (2 * x - s.width) / s.height, b = (s.height - 2 * y) / s.height;
        return {s.eye, unit(right * a + up * b - backward), {1, 1, 1}, {0, 0, 0}, true};
    }

    void tile(int left, int top) {
        int columns = std::min(TILE, s.width - left), rows = std::min(TILE, s.height - top), n = samples * samples;
        std::vector<Path> paths;
        for (int i = 0; i < columns * rows * n; i++) {
            int pixel = i / n, sample = i % n;
            paths.push_back(through(left + pixel % columns + (sample % samples + .5f) / samples,
                    top + pixel / columns + (sample / samples + .5f) / samples));
        }
        while (packets && paths.size() % PACKET) { paths.push_back(paths.back()); paths.back().alive = false; }
        for (size_t i = 0; i < paths.size(); i += packets ? PACKET : 1) {
            if (packets) traceSixteen(s, &paths[i]); else traceOne(s, paths[i]);
        }
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            Vec sum{0, 0, 0};
            for (int k = 0; k < n; k++) {
                Vec c = paths[pixel * n + k].light;
                sum = sum + Vec{std::min(1.f, c.x), std::min(1.f, c.y), std::min(1.f, c.z)};
            }
            unsigned char *out = &bytes[3 * ((size_t) (top + pixel / columns) * s.width + left + pixel % columns)];
            float means[3] = {sum.x / n, sum.y / n, sum.z / n};
            for (int k = 0; k < 3; k++) out[k] = means[k] * 255 + .5f;
        }
    }

    void work() {
        int across = (s.width + TILE - 1) / TILE, down = (s.height + TILE - 1) / TILE;
        for (int t; (t = next++) < across * down;) tile(t % across * TILE, t / across * TILE);
    }
};

int main(int count, char **arguments) {
    if (count != 5) { std::fprintf(stderr, "usage: embree SCENE OUT.ppm SAMPLES ray|packet\n"); return 2; }
    Scene scene = read(arguments[1]);
    build(scene);
    Picture picture(scene, std::atoi(arguments[3]), std::string(arguments[4]) == "packet");
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); i++) threads.emplace_back([&] { picture.work(); });
    for (std::thread &thread : threads) thread.join();
    FILE *out = std::fopen(arguments[2], "wb");
    std::fprintf(out, "P6\n%d %d\n255\n", scene.width, scene.height);
    std::fwrite(picture.bytes.data(), 1, picture.bytes.size(), out);
    return std::fclose(out) == 0 ? 0 : 1;
}
