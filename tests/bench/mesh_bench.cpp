// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of both indexes on a mesh of a million triangles, a bumpy ball, beside Embree 3 where its
// headers are there: build time, then million rays a second. Run by hand: mesh_bench [steps], which
// makes 4 steps^2 triangles, or mesh_bench needles [count], long thin triangles in all directions;
// NODE_COST, GROUP_COST and REFERENCE_COST in the environment replace the defaults of the kd-tree.
// Rays: through a camera's pixels, cosine-distributed from what they hit, and from there to points
// of a light above (any hit). One thread everywhere.
#include "index/tree_builder.h"
#include "rays.h"
#include "shape/leaf_pack.h"
#include "shape/triangle.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <optional>
#include <random>

using namespace candelabra;

namespace {

using std::numbers::pi;

struct Surface {
    std::vector<Vec3> points;
    std::vector<std::array<unsigned, 3>> faces;

    std::vector<Triangle> flat;  ///< the faces, as the world keeps them
};

Surface bumpy_ball(unsigned steps) {
    Surface made;
    const unsigned around = 2 * steps;
    for (unsigned i = 0; i <= steps; ++i)
        for (unsigned j = 0; j < around; ++j) {
            const double up = pi * i / steps, turn = 2 * pi * j / around;
            const double radius = 1 + 0.1 * std::sin(9 * turn) * std::sin(7 * up) +
                                  0.02 * std::sin(90 * turn + 80 * up);
            made.points.push_back(radius * Vec3(std::sin(up) * std::cos(turn), std::cos(up),
                                                std::sin(up) * std::sin(turn)));
        }
    for (unsigned i = 0; i < steps; ++i)
        for (unsigned j = 0; j < around; ++j) {
            const unsigned a = i * around + j, b = i * around + (j + 1) % around;
            made.faces.push_back({a, b, b + around});
            made.faces.push_back({a, b + around, a + around});
        }
    for (const auto& [a, b, c] : made.faces)
        made.flat.push_back({made.points[a], made.points[b], made.points[c]});
    return made;
}

Surface needles(unsigned count) {
    Surface made;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&] {
        const double x = uniform(random), y = uniform(random);
        return Vec3(x, y, uniform(random));
    };
    for (unsigned i = 0; i < count; ++i) {
        const Vec3 from = point(), along = unit(point()), aside = 0.002 * unit(point());
        made.points.insert(made.points.end(), {from, from + along, from + aside});
        made.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        made.flat.push_back({from, from + along, from + aside});
    }
    return made;
}

struct Found {
    double t = far_away;
    std::uint32_t face = 0;
};

WideTree tree_of(const Surface& mesh, const TreeSettings& settings) {
    const auto count = static_cast<std::uint32_t>(mesh.flat.size());
    WideTree tree = build_tree(
        count, [&](std::uint32_t i) { return bounds(mesh.flat[i]); },
        [&](std::uint32_t i, const Box& cell) { return clipped_bounds(mesh.flat[i], cell); },
        settings, 1);
    const auto corners = [&](std::uint32_t i) {
        const Triangle& face = mesh.flat[i];
        return std::array{face.corner1, face.corner2, face.corner3};
    };
    tree.pack(leaf_packs({0, count, {}, corners, {}}), 1);
    return tree;
}

Found first_hit(const WideTree& tree, const Surface& mesh, const Ray& ray) {
    Found found;
    std::optional<ShearedRay> sheared;
    PackRay packed(ray);
    tree.traverse(ray, {0, far_away}, [&](const TreeLeaf& leaf, Interval& range) {
        return packed.candidates(leaf, range, [&](std::uint32_t item) {
            const Triangle& f = mesh.flat[item];
            if (!sheared) sheared.emplace(ray);
            const TriangleHit met = sheared->meet(f.corner1, f.corner2, f.corner3, range);
            if (met.t < range.max) range.max = met.t, found = {met.t, item};
            return false;
        });
    });
    return found;
}

bool blocked(const WideTree& tree, const Surface& mesh, const Ray& ray, double distance) {
    std::optional<ShearedRay> sheared;
    PackRay packed(ray);
    return tree.traverse_likely(ray, {0, distance}, [&](const TreeLeaf& leaf, Interval& range) {
        return packed.blocked(leaf, range, [&](std::uint32_t item) {
            const Triangle& f = mesh.flat[item];
            if (!sheared) sheared.emplace(ray);
            return sheared->meet(f.corner1, f.corner2, f.corner3, range).t < range.max;
        });
    });
}

Rays make_rays(const WideTree& tree, const Surface& mesh, int width) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    Rays rays;
    const Vec3 eye(0, 0, -4);
    for (int i = 0; i < width * width; ++i) {
        const Vec3 ahead(2.4 * (i % width + 0.5) / width - 1.2,
                         2.4 * (i / width + 0.5) / width - 1.2, 4);
        const Ray ray{eye, unit(ahead)};
        rays.camera.push_back({ray});
        const Found found = first_hit(tree, mesh, ray);
        if (found.t == far_away) continue;
        const Triangle face = mesh.flat[found.face];
        Vec3 normal = triangle_normal(face.corner1, face.corner2, face.corner3);
        if (dot(normal, ray.direction) > 0) normal = -normal;
        const Vec3 start = ray.at(found.t) + 1e-5 * normal;
        const double z = 2 * uniform(random) - 1, turn = 2 * pi * uniform(random);
        const double r = std::sqrt(1 - z * z);
        rays.bounce.push_back(
            {{start, unit(normal + Vec3(r * std::cos(turn), r * std::sin(turn), z))}});
        const Vec3 to = Vec3(4 * uniform(random) - 2, 3, 4 * uniform(random) - 4) - start;
        if (dot(to, normal) > 0) rays.shadow.push_back({{start, unit(to)}, length(to)});
    }
    return rays;
}

#ifdef WITH_EMBREE
void fill(RTCGeometry geometry, const Surface& mesh) {
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.points.size()));
    for (const Vec3& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(p[axis]);
    auto* faces = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.faces.size()));
    for (const auto& face : mesh.faces)
        for (const unsigned corner : face) *faces++ = corner;
}
#endif

}  // namespace

int main(int argc, char** argv) {
    const bool thin = argc > 1 && std::strcmp(argv[1], "needles") == 0;
    const auto number = [&](int place, unsigned otherwise) {
        return argc > place ? static_cast<unsigned>(std::atoi(argv[place])) : otherwise;
    };
    const Surface mesh = thin ? needles(number(2, 10000)) : bumpy_ball(number(1, 500));
    const auto trees = build_both([&](const auto& settings) { return tree_of(mesh, settings); });
    std::printf("%zu triangles\n", mesh.faces.size());
    print_trees(trees, mesh.faces.size());
    print_head();
    const auto [kd, boxes] = std::tie(trees[0].tree, trees[1].tree);
    const Rays rays = make_rays(kd, mesh, thin ? 128 : 512);
    const auto meets = [&](const WideTree& tree) {
        return [&](const Segment& s) { return first_hit(tree, mesh, s.ray).t < far_away; };
    };
    const auto blocks = [&](const WideTree& tree) {
        return [&](const Segment& s) { return blocked(tree, mesh, s.ray, s.length); };
    };
#ifdef WITH_EMBREE
    const double start = seconds();
    const Embree embree(RTC_GEOMETRY_TYPE_TRIANGLE, RTC_SCENE_FLAG_ROBUST,  // watertight, as ours
                        [&](RTCGeometry geometry) { fill(geometry, mesh); });
    print_row("build s", trees[0].build_time, trees[1].build_time, seconds() - start);
    const auto embree_meets = [&](const Segment& s) { return embree.meets(s); };
    const auto embree_blocks = [&](const Segment& s) { return embree.blocks(s); };
    const auto print = [&](const char* what, const auto& segments, auto... by) {
        print_speeds(what, compare(segments, by...));
        print_speeds("  once", compare_once(segments, by...));
    };
    print("camera M/s", rays.camera, meets(kd), meets(boxes), embree_meets);
    print("bounce M/s", rays.bounce, meets(kd), meets(boxes), embree_meets);
    print("shadow M/s", rays.shadow, blocks(kd), blocks(boxes), embree_blocks);
#else
    print_row("build s", trees[0].build_time, trees[1].build_time, 0);
    print_speeds("camera M/s", compare(rays.camera, meets(kd), meets(boxes)));
    print_speeds("bounce M/s", compare(rays.bounce, meets(kd), meets(boxes)));
    print_speeds("shadow M/s", compare(rays.shadow, blocks(kd), blocks(boxes)));
#endif
}
