// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of both indexes on Haines' sphereflake pair, beside Embree 3 where its headers are there:
// build time, then million rays a second. Run by hand: flake_bench [depth ...], or flake_bench
// growth, which is the time for a ray among more and more spheres. Rays: through a camera's pixels,
// cosine-distributed from what they hit, and from there to luminaires (any hit). One thread
// everywhere. NODE_COST, GROUP_COST and REFERENCE_COST in the environment replace the defaults of
// the kd-tree.
#include "index/tree_builder.h"
#include "rays.h"
#include "shape/leaf_pack.h"
#include "shape/sphere.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

using namespace candelabra;

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
inline double intersect(const Ball& b, const Ray& ray, const Interval& range) {
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

Hit first_hit(const WideTree& tree, const std::vector<Ball>& balls, const Ray& ray) {
    Hit hit;
    PackRay packed(ray);
    tree.traverse(ray, {0, far_away}, [&](const TreeLeaf& leaf, Interval& range) {
        return packed.candidates(leaf, range, [&](std::uint32_t item) {
            const double t = intersect(balls[item], ray, range);
            if (t < range.max) {
                range.max = t;
                hit = {t, item};
            }
            return false;
        });
    });
    return hit;
}

bool blocked(const WideTree& tree, const std::vector<Ball>& balls, const Ray& ray,
             double distance) {
    PackRay packed(ray);
    return tree.traverse_likely(ray, {0, distance}, [&](const TreeLeaf& leaf, Interval& range) {
        return packed.blocked(leaf, range, [&](std::uint32_t item) {
            return intersect(balls[item], ray, range) < range.max;
        });
    });
}

Vec3 sphere_point(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double z = 2 * uniform(random) - 1;
    const double angle = 2 * pi * uniform(random);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

Rays make_rays(const WideTree& tree, const std::vector<Ball>& balls, int width) {
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

WideTree tree_of(const std::vector<Ball>& balls, const TreeSettings& settings) {
    const auto count = static_cast<std::uint32_t>(balls.size());
    WideTree tree = build_tree(
        count, [&](std::uint32_t i) { return bounds(balls[i]); },
        [&](std::uint32_t i, const Box& cell) {
            return clipped_bounds(Sphere{balls[i].centre, balls[i].radius}, cell);
        },
        settings, 1);
    const auto ball = [&](std::uint32_t i) {
        return PackedKinds::Ball{balls[i].centre, balls[i].radius};
    };
    tree.pack(leaf_packs({count, count, ball, {}, {}}), 1);
    return tree;
}

void shoot(const std::array<Measured, 2>& trees, const std::vector<Ball>& balls) {
    const Rays rays = make_rays(trees[0].tree, balls, 512);
    const auto meets = [&](const WideTree& tree) {
        return [&](const Segment& r) { return first_hit(tree, balls, r.ray).t < far_away; };
    };
    const auto blocks = [&](const WideTree& tree) {
        return [&](const Segment& r) { return blocked(tree, balls, r.ray, r.length); };
    };
    const auto [kd, boxes] = std::tie(trees[0].tree, trees[1].tree);
#ifdef WITH_EMBREE
    const double start = seconds();
    const Embree embree(RTC_GEOMETRY_TYPE_SPHERE_POINT, RTC_SCENE_FLAG_NONE,
                        [&](RTCGeometry geometry) { fill(geometry, balls); });
    print_row("build s", trees[0].build_time, trees[1].build_time, seconds() - start);
    const auto embree_meets = [&](const Segment& r) { return embree.meets(r); };
    const auto embree_blocks = [&](const Segment& r) { return embree.blocks(r); };
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

void run(int depth) {
    const std::vector<Ball> balls = flakes(depth);
    const auto trees = build_both([&](const auto& settings) { return tree_of(balls, settings); });
    std::printf("\nsphereflake pair, depth %d: %zu spheres\n", depth, balls.size());
    print_trees(trees, balls.size());
    print_head();
    shoot(trees, balls);
}

/// Balls all over a cube, with as much surface altogether whatever their number.
std::vector<Ball> cloud(std::size_t count) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double radius = 0.5 / std::sqrt(static_cast<double>(count));
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = uniform(random), y = uniform(random);
        balls.push_back({Vec3(x, y, uniform(random)), radius});
    }
    return balls;
}

/// Of rays through a cube of spheres, microseconds each, and over the logarithm of their number.
void grow() {
    std::printf("%9s %12s %16s %12s %16s\n", "spheres", "kd_tree us", "over log2 n", "boxes us",
                "over log2 n");
    for (const std::size_t count : {1000, 10'000, 100'000, 1'000'000}) {
        const std::vector<Ball> balls = cloud(count);
        const auto trees =
            build_both([&](const auto& settings) { return tree_of(balls, settings); });
        std::mt19937_64 random(6);
        std::vector<Segment> rays;
        for (int i = 0; i < 200'000; ++i) {
            const Vec3 from = 3.0 * sphere_point(random), to = sphere_point(random);
            rays.push_back({{from, unit(to - from)}});
        }
        const auto meets = [&](const WideTree& tree) {
            return [&](const Segment& r) { return first_hit(tree, balls, r.ray).t < far_away; };
        };
        const auto speeds = compare_once(rays, meets(trees[0].tree), meets(trees[1].tree));
        const double levels = std::log2(static_cast<double>(count));
        const double kd = 1e6 / speeds[0].rays_per_second, bb = 1e6 / speeds[1].rays_per_second;
        std::printf("%9zu %12.3f %16.4f %12.3f %16.4f\n", count, kd, kd / levels, bb, bb / levels);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "growth") == 0) {
        grow();
        return 0;
    }
    if (argc == 1) {
        for (const int depth : {4, 5, 6}) run(depth);
    }
    for (int i = 1; i < argc; ++i) run(std::atoi(argv[i]));
}
