// SPDX-License-Identifier: GPL-3.0-or-later
// What the benchmarks of rays share: rays to shoot, how fast they are shot, and Embree 3 as the
// opponent where its headers are there.
#pragma once

#include "base/ray.h"

#if __has_include(<embree3/rtcore.h>) && !defined(NO_EMBREE)
#define WITH_EMBREE 1
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

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

/// The best of several passes: the machine may be shared.
template <class Shoot>
Speed measure(const std::vector<Segment>& rays, std::size_t step, Shoot shoot) {
    Speed best;
    for (int pass = 0; pass < (step > 1 ? 1 : 5); ++pass) {
        std::size_t found = 0;
        const double start = seconds();
        for (std::size_t i = 0; i < rays.size(); i += step) found += shoot(rays[i]);
        const double count = static_cast<double>((rays.size() + step - 1) / step);
        best.rays_per_second = std::max(best.rays_per_second, count / (seconds() - start));
        best.found = static_cast<double>(found) / count;
    }
    return best;
}

/// Shoots the rays by both in turns, a few hundred each, and adds up the best times: what else the
/// machine does meanwhile slows both. Caches and branch predictors know these rays.
template <class Ours, class Theirs>
std::pair<Speed, Speed> compare(const std::vector<Segment>& rays, Ours ours, Theirs theirs) {
    constexpr std::size_t piece = 500;
    constexpr int passes = 16;
    struct Side {
        double time = 0;
        std::size_t found = 0;
    } mine, other;
    for (std::size_t first = 0; first < rays.size(); first += piece) {
        const std::size_t end = std::min(rays.size(), first + piece);
        const auto shoot = [&](auto& by) {
            const double start = seconds();
            std::size_t found = 0;
            for (std::size_t i = first; i < end; ++i) found += by(rays[i]);
            return Side{seconds() - start, found};
        };
        Side best{far_away}, best_other{far_away};
        for (int pass = 0; pass < passes; ++pass) {
            const Side a = shoot(ours), b = shoot(theirs);
            best = {std::min(best.time, a.time), a.found};
            best_other = {std::min(best_other.time, b.time), b.found};
        }
        mine = {mine.time + best.time, mine.found + best.found};
        other = {other.time + best_other.time, other.found + best_other.found};
    }
    const auto speed = [&](const Side& side) {
        const double count = static_cast<double>(rays.size());
        return Speed{count / side.time, static_cast<double>(side.found) / count};
    };
    return {speed(mine), speed(other)};
}

/// Shoots all rays by both in turns, so that caches and branch predictors know none of them when
/// they come again, and takes the best times.
template <class Ours, class Theirs>
std::pair<Speed, Speed> compare_once(const std::vector<Segment>& rays, Ours ours, Theirs theirs) {
    constexpr int passes = 7;
    const auto shoot = [&](auto& by, Speed& best) {
        std::size_t found = 0;
        const double start = seconds();
        for (const Segment& ray : rays) found += by(ray);
        const double count = static_cast<double>(rays.size());
        best = {std::max(best.rays_per_second, count / (seconds() - start)),
                static_cast<double>(found) / count};
    };
    Speed mine, other;
    for (int pass = 0; pass < passes; ++pass) {
        shoot(ours, mine);
        shoot(theirs, other);
    }
    return {mine, other};
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
