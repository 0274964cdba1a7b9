// SPDX-License-Identifier: GPL-3.0-or-later
// What the benchmarks of rays share: rays to shoot, how fast they are shot, and Embree 3 as the
// opponent where its headers are there.
#pragma once

#include "base/ray.h"
#include "index/settings.h"
#include "index/statistics.h"

#if __has_include(<embree3/rtcore.h>) && !defined(NO_EMBREE)
#define WITH_EMBREE 1
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

namespace candelabra {

inline constexpr double far_away = std::numeric_limits<double>::infinity();

struct Segment {
    Ray ray;
    double length = far_away;
};

struct Rays {
    std::vector<Segment> camera, bounce, shadow;
};

inline double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// A setting's default, unless the environment replaces it.
inline void read_setting(const char* name, double& value) {
    if (const char* text = std::getenv(name)) value = std::atof(text);
}

struct Speed {
    double rays_per_second = 0;
    double found = 0;  ///< fraction of the rays
};

/// Shoots the rays by all in turns, a few hundred each, and adds up the best times: what else the
/// machine does meanwhile slows all. Caches and branch predictors know these rays.
template <class... Shoot>
std::array<Speed, sizeof...(Shoot)> compare(const std::vector<Segment>& rays, Shoot... shoot) {
    constexpr std::size_t piece = 500, sides = sizeof...(Shoot);
    constexpr int passes = 16;
    struct Side {
        double time = far_away;
        std::size_t found = 0;
    };
    std::array<Side, sides> sum;
    sum.fill({0});
    for (std::size_t first = 0; first < rays.size(); first += piece) {
        const std::size_t end = std::min(rays.size(), first + piece);
        const auto pass = [&](auto& by, Side& best) {
            const double start = seconds();
            std::size_t found = 0;
            for (std::size_t i = first; i < end; ++i) found += by(rays[i]);
            best = {std::min(best.time, seconds() - start), found};
        };
        std::array<Side, sides> best;
        for (int i = 0; i < passes; ++i) {
            std::size_t side = 0;
            (pass(shoot, best[side++]), ...);
        }
        for (std::size_t side = 0; side < sides; ++side) {
            sum[side].time += best[side].time;
            sum[side].found += best[side].found;
        }
    }
    const double count = static_cast<double>(rays.size());
    std::array<Speed, sides> speeds;
    for (std::size_t side = 0; side < sides; ++side)
        speeds[side] = {count / sum[side].time, static_cast<double>(sum[side].found) / count};
    return speeds;
}

/// Shoots all rays by all in turns, so that caches and branch predictors know none of them when
/// they come again, and takes the best times.
template <class... Shoot>
std::array<Speed, sizeof...(Shoot)> compare_once(const std::vector<Segment>& rays, Shoot... shoot) {
    constexpr int passes = 7;
    const auto pass = [&](auto& by, Speed& best) {
        std::size_t found = 0;
        const double start = seconds();
        for (const Segment& ray : rays) found += by(ray);
        const double count = static_cast<double>(rays.size());
        best = {std::max(best.rays_per_second, count / (seconds() - start)),
                static_cast<double>(found) / count};
    };
    std::array<Speed, sizeof...(Shoot)> speeds;
    for (int i = 0; i < passes; ++i) {
        std::size_t side = 0;
        (pass(shoot, speeds[side++]), ...);
    }
    return speeds;
}

/// A table of both indexes beside each other, and Embree where it is there.
inline void print_head() {
    std::printf("%-12s %10s %14s %10s %10s %10s %10s\n", "", "kd_tree", "bounding_boxes", "Embree",
                "kd/Embree", "bb/Embree", "kd/bb");
}
inline void print_row(const char* what, double kd, double boxes, double embree) {
    std::printf("%-12s %10.3f %14.3f %10.3f %10.2f %10.2f %10.2f\n", what, kd, boxes, embree,
                kd / embree, boxes / embree, kd / boxes);
}
template <std::size_t sides>
void print_speeds(const char* what, const std::array<Speed, sides>& speeds) {
    const double embree = sides > 2 ? speeds[sides - 1].rays_per_second : 0;
    print_row(what, 1e-6 * speeds[0].rays_per_second, 1e-6 * speeds[1].rays_per_second,
              1e-6 * embree);
    for (const Speed& s : speeds)
        if (std::abs(s.found - speeds[0].found) > 1e-3)
            std::printf("  of these rays %.4f hit, of the others %.4f\n", s.found, speeds[0].found);
}

/// What the table's columns are of.
struct Measured {
    WideTree tree;
    double build_time;
};

/// Both indexes, each built by build(settings) -> WideTree. Costs in the environment replace those
/// of the kd-tree.
template <class Build>
std::array<Measured, 2> build_both(Build build) {
    KdTree kd;
    read_setting("NODE_COST", kd.node_cost);
    read_setting("GROUP_COST", kd.group_cost);
    read_setting("REFERENCE_COST", kd.reference_cost);
    const auto timed = [&](const RayIndex& index) {
        const double start = seconds();
        WideTree tree = build(tree_settings(index));
        return Measured{std::move(tree), seconds() - start};
    };
    return {timed(kd), timed(BoundingBoxes())};
}

inline void print_trees(const std::array<Measured, 2>& trees, std::size_t items) {
    for (const auto& [tree, time] : trees) {
        const TreeStatistics s = statistics(tree);
        std::printf(
            "%s: %.1f bytes an item, %.2f references an item, %zu nodes, %zu leaves, depth %d, "
            "%.2f items a leaf, cost %.2f\n",
            tree.settings().by == Division::cells ? "kd_tree" : "bounding_boxes",
            static_cast<double>(s.bytes) / static_cast<double>(items),
            static_cast<double>(s.references) / static_cast<double>(items), s.nodes, s.leaves,
            s.max_depth, s.mean_items_per_leaf, s.cost);
    }
}

#ifdef WITH_EMBREE
/// A scene of one geometry, of the best quality, in one thread.
class Embree {
public:
    /// `fill` puts the content into the geometry.
    template <class Fill>
    Embree(RTCGeometryType type, RTCSceneFlags flags, Fill fill) {
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        rtcSetSceneFlags(scene_, flags);
        RTCGeometry geometry = rtcNewGeometry(device_, type);
        fill(geometry);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    bool meets(const Segment& s) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray = ray(s);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    bool blocks(const Segment& s) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay query = ray(s);
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0;
    }

private:
    static RTCRay ray(const Segment& s) {
        RTCRay r{};
        r.org_x = static_cast<float>(s.ray.origin.x);
        r.org_y = static_cast<float>(s.ray.origin.y);
        r.org_z = static_cast<float>(s.ray.origin.z);
        r.dir_x = static_cast<float>(s.ray.direction.x);
        r.dir_y = static_cast<float>(s.ray.direction.y);
        r.dir_z = static_cast<float>(s.ray.direction.z);
        r.tfar = static_cast<float>(s.length);
        r.mask = ~0u;
        return r;
    }

    RTCDevice device_ = rtcNewDevice("threads=1");
    RTCScene scene_ = rtcNewScene(device_);
};
#endif

}  // namespace candelabra
