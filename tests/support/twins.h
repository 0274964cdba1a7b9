// SPDX-License-Identifier: GPL-3.0-or-later
// A scene compiled twice: with unions that are stored once, and with all of them taken apart.
#pragma once

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

struct Twins {
    SharedWorld shared, apart;
};

inline SharedWorld world_with(const std::string& script, const InstanceLimits& limits) {
    CompileOptions options;
    options.instances = limits;
    Diagnostics diagnostics;
    return compile(scene_of(script), options, diagnostics);
}

inline Twins twins_of(const std::string& script) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    return {world_with(script, {2, most, 2}), world_with(script, {most, most, most})};
}

/// Checks that rays meet the same places in both worlds, and calls check(ray, hit, hit apart) where
/// they do. Returns how many of them met instances.
template <class NextRay, class Check>
int met_alike(const Twins& twins, const NextRay& next_ray, const Check& check) {
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
        const Ray ray = next_ray();
        Hit one, other;
        const bool here = twins.shared->first_hit(ray, 0, RayKind::camera, one);
        REQUIRE(here == twins.apart->first_hit(ray, 0, RayKind::camera, other));
        if (!here) continue;
        met += twins.shared->geometry.is_instanced(one.primitive) ? 1 : 0;
        CHECK(length(one.position - other.position) < 1e-9);
        check(ray, one, other);
    }
    return met;
}

}  // namespace candelabra
