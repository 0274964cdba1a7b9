// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the hierarchy of boxes on Haines' sphereflake pair, against brute force and, where its
// headers are there, Embree 3: build time, then million rays a second. Run by hand: bvh_bench
// [depth ...]. The last column is the ratio to the opponent. Rays: through a camera's pixels,
// cosine-distributed from what they hit, and from there to luminaires (any hit). One thread
// everywhere. NODE_COST and GROUP_COST in the environment replace the settings' defaults.
#include "index/brute.h"
#include "index/bvh_builder.h"
#include "index/statistics.h"
#include "rays.h"
#include "shape/leaf_pack.h"

#include <cstdio>
#include <cstdlib>
#include <random>
#include <type_traits>

namespace {

struct Ball {
    Vec3 centre;
    double radius;
};

constexpr double pi = 3.14159265358979323846;

/// Nine children of a third of the radius: six around the axis by which the ball hangs on its
/// parent, three above.
void add_flake(const Ball& ball, const Vec3& axis, int depth, std::vector<Ball>& balls) {
    balls.push_back(ball);
    if (depth == 0) return;
    const Vec3 z(0, 0, 1);
    const Vec3 turn = cross(z, axis);
    const double cosine = axis.z;
    const auto turned = [&](const Vec3& v) {  // the shortest rotation that takes z to the axis
        if (cosine < -1 + 1e-12) return Vec3(v.x, -v.y, -v.z);
        return v * cosine + cross(turn, v) + turn * (dot(turn, v) / (1 + cosine));
    };
    for (int i = 0; i < 9; ++i) {
        const double azimuth = (i < 6 ? 15 + 60 * i : 45 + 120 * (i - 6)) * pi / 180;
        const double sine = i < 6 ? 0 : std::sqrt(2.0 / 3);
        const double level = std::sqrt(1 - sine * sine);
        const Vec3 direction =
            turned(Vec3(level * std::cos(azimuth), level * std::sin(azimuth), sine));
        add_flake({ball.centre + direction * (ball.radius * 4 / 3), ball.radius / 3}, direction,
                  depth - 1, balls);
    }
}

std::vector<Ball> flakes(int depth) {
    std::vector<Ball> balls;
    add_flake({Vec3(-2.1, 0, 1), 1}, Vec3(0, 0, 1), depth, balls);
    add_flake({Vec3(2.1, 0, 1), 1}, Vec3(0, 0, 1), depth, balls);
    return balls;
}

Box bounds(const Ball& b) { return {b.centre - Vec3(b.radius), b.centre + Vec3(b.radius)}; }

/// Nearest crossing in the range, from the point of the ray closest to the centre; infinite when
/// there is none.
inline double meet(const Ball& b, const Ray& ray, const Interval& range) {
    const Vec3 to = b.centre - ray.origin;
    const double along = dot(to, ray.direction);
    const Vec3 off = to - along * ray.direction;
    const double spare = b.radius * b.radius - dot(off, off);
    if (spare < 0) return far_away;
    const double half = std::sqrt(spare);
    if (range.contains(along - half)) return along - half;
    return range.contains(along + half) ? along + half : far_away;
}

struct Hit {
    double t = far_away;
    std::uint32_t item = 0;
};

/// Calls ask(item) -> bool for the balls that the ray may meet in a leaf.
template <class Ask>
bool ask_leaf(PackRay& packed, const BvhLeaf& leaf, const Interval& range, Ask ask) {
    return packed.candidates(leaf, range, ask);
}
template <class Ask>
bool ask_leaf(PackRay&, std::span<const std::uint32_t> items, const Interval&, Ask ask) {
    return std::ranges::any_of(items, ask);
}

template <class Ask>
bool ask_any(PackRay& packed, const BvhLeaf& leaf, const Interval& range, Ask ask) {
    return packed.blocked(leaf, range, ask);
}
template <class Ask>
bool ask_any(PackRay&, std::span<const std::uint32_t> items, const Interval&, Ask ask) {
    return std::ranges::any_of(items, ask);
}

/// What the index calls its leaves.
template <class Index>
using LeafOf =
    std::conditional_t<std::is_same_v<Index, Bvh>, const BvhLeaf&, std::span<const std::uint32_t>>;

template <class Index>
Hit first_hit(const Index& index, const std::vector<Ball>& balls, const Ray& ray) {
    Hit hit;
    PackRay packed(ray);
    index.traverse(ray, {0, far_away}, [&](LeafOf<Index> leaf, Interval& range) {
        return ask_leaf(packed, leaf, range, [&](std::uint32_t item) {
            const double t = meet(balls[item], ray, range);
            if (t < range.max) {
                range.max = t;
                hit = {t, item};
            }
            return false;
        });
    });
    return hit;
}

template <class Index>
bool blocked(const Index& index, const std::vector<Ball>& balls, const Ray& ray, double distance) {
    PackRay packed(ray);
    const auto visit = [&](LeafOf<Index> leaf, Interval& range) {
        return ask_any(packed, leaf, range, [&](std::uint32_t item) {
            return meet(balls[item], ray, range) < range.max;
        });
    };
    if constexpr (std::is_same_v<Index, Bvh>)
        return index.traverse_likely(ray, {0, distance}, visit);
    else
        return index.traverse(ray, {0, distance}, visit);
}

Vec3 sphere_point(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double z = 2 * uniform(random) - 1;
    const double angle = 2 * pi * uniform(random);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

Rays make_rays(const Bvh& tree, const std::vector<Ball>& balls, int width) {
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::size_t> any_luminaire(balls.size() / 2, balls.size() - 1);
    Rays rays;
    const Vec3 eye(0, -10, 7);
    const Vec3 ahead = unit(Vec3(0, 0, 0.7) - eye);
    const Vec3 right(1, 0, 0);
    const Vec3 up = cross(right, ahead);
    const double scale = std::tan(21 * pi / 180);
    for (int i = 0; i < width * width; ++i) {
        const double x = (2 * (i % width + 0.5) / width - 1) * scale;
        const double y = (1 - 2 * (i / width + 0.5) / width) * scale;
        const Ray ray{eye, unit(ahead + x * right + y * up)};
        rays.camera.push_back({ray});
        const Hit hit = first_hit(tree, balls, ray);
        const double floor = ray.direction.z < 0 ? -ray.origin.z / ray.direction.z : far_away;
        if (hit.t == far_away && floor > 100) continue;
        const Vec3 point = ray.at(std::min(hit.t, floor));
        const Vec3 normal = hit.t < floor ? unit(point - balls[hit.item].centre) : Vec3(0, 0, 1);
        const Vec3 start = point + 1e-4 * normal;
        rays.bounce.push_back({{start, unit(normal + sphere_point(random))}});
        const Ball& light = balls[any_luminaire(random)];
        Vec3 outward = sphere_point(random);
        if (dot(outward, start - light.centre) < 0) outward = -outward;
        const Vec3 to = light.centre + light.radius * 1.001 * outward - start;
        if (dot(to, normal) > 0) rays.shadow.push_back({{start, unit(to)}, length(to)});
    }
    return rays;
}

void print_speed(const char* what, const char* opponent, const Speed& ours, const Speed& theirs) {
    std::printf("%-12s %12.3f (%5.2f %% hit) %-12s %12.4f (%5.2f %% hit) %10.2f\n", what,
                ours.rays_per_second * 1e-6, ours.found * 100, opponent,
                theirs.rays_per_second * 1e-6, theirs.found * 100,
                ours.rays_per_second / theirs.rays_per_second);
}

#ifdef WITH_EMBREE
void fill(RTCGeometry geometry, const std::vector<Ball>& balls) {
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), balls.size()));
    for (const Ball& b : balls) {
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(b.centre[axis]);
        *vertices++ = static_cast<float>(b.radius);
    }
}
#endif

Bvh tree_of(const std::vector<Ball>& balls, const BvhSettings& settings) {
    const auto count = static_cast<std::uint32_t>(balls.size());
    Bvh tree = build_bvh(
        count, [&](std::uint32_t i) { return bounds(balls[i]); }, {}, settings, 1);
    const auto ball = [&](std::uint32_t i) {
        return PackedKinds::Ball{balls[i].centre, balls[i].radius};
    };
    tree.pack(leaf_packs({count, count, ball, {}, {}}), 1);
    return tree;
}

void run(int depth) {
    const std::vector<Ball> balls = flakes(depth);
    BvhSettings settings;
    read_setting("NODE_COST", settings.node_cost);
    read_setting("GROUP_COST", settings.group_cost);

    const double start = seconds();
    const Bvh tree = tree_of(balls, settings);
    const double build_time = seconds() - start;
    const BvhStatistics s = statistics(tree);
    std::printf(
        "\nsphereflake pair, depth %d: %zu spheres, %.1f bytes a sphere, %zu nodes, %zu leaves, "
        "depth %d,\n%.2f items a leaf (at most %zu), %zu asked before all others, cost %.2f\n",
        depth, balls.size(), static_cast<double>(s.bytes) / static_cast<double>(balls.size()),
        s.nodes, s.leaves, s.max_depth, s.mean_items_per_leaf, s.max_items_per_leaf,
        8 * tree.foremost().size(), s.cost);
    std::printf("%-12s %12s %13s %-12s %12s %13s %10s\n", "case", "hierarchy", "", "opponent",
                "its", "", "ratio");

    const Rays rays = make_rays(tree, balls, 512);
    const auto meets = [&](const auto& index) {
        return [&](const Segment& r) { return first_hit(index, balls, r.ray).t < far_away; };
    };
    const auto blocks = [&](const auto& index) {
        return [&](const Segment& r) { return blocked(index, balls, r.ray, r.length); };
    };
    if (balls.size() < 100000) {
        const BruteForce brute(balls.size());
        const std::size_t step = 1 + balls.size() / 100;
        print_speed("camera M/s", "brute force", measure(rays.camera, 1, meets(tree)),
                    measure(rays.camera, step, meets(brute)));
        print_speed("bounce M/s", "brute force", measure(rays.bounce, 1, meets(tree)),
                    measure(rays.bounce, step, meets(brute)));
        print_speed("shadow M/s", "brute force", measure(rays.shadow, 1, blocks(tree)),
                    measure(rays.shadow, step, blocks(brute)));
    }
#ifdef WITH_EMBREE
    const double embree_start = seconds();
    const Embree embree(RTC_GEOMETRY_TYPE_SPHERE_POINT, RTC_SCENE_FLAG_NONE,
                        [&](RTCGeometry geometry) { fill(geometry, balls); });
    const double embree_time = seconds() - embree_start;
    std::printf("%-12s %12.3f %13s %-12s %12.3f %13s %10.2f\n", "build s", build_time, "", "Embree",
                embree_time, "", build_time / embree_time);
    const auto embree_meets = [&](const Segment& r) { return embree.meets(r); };
    const auto embree_blocks = [&](const Segment& r) { return embree.blocks(r); };
    const auto versus = [&](const char* what, const auto& segments, auto ours, auto theirs) {
        const auto [mine, other] = compare(segments, ours, theirs);
        print_speed(what, "Embree", mine, other);
        const auto [my_once, other_once] = compare_once(segments, ours, theirs);
        print_speed("  once", "Embree", my_once, other_once);
    };
    versus("camera M/s", rays.camera, meets(tree), embree_meets);
    versus("bounce M/s", rays.bounce, meets(tree), embree_meets);
    versus("shadow M/s", rays.shadow, blocks(tree), embree_blocks);
#else
    std::printf("%-12s %12.3f\n", "build s", build_time);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 1) {
        for (const int depth : {4, 5, 6}) run(depth);
    }
    for (int i = 1; i < argc; ++i) run(std::atoi(argv[i]));
}
