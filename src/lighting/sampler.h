// SPDX-License-Identifier: GPL-3.0-or-later
// Which luminaires to ask at a point: the interface of the light sampling strategies. The
// renderer's estimator is one line for all of them: the sum of contribution / expected over the
// picks.
#pragma once

#include "base/random.h"
#include "lighting/constant_alpha.h"
#include "lighting/every_light.h"
#include "lighting/light_bvh.h"
#include "lighting/light_octree.h"
#include "lighting/linear_alpha.h"
#include "lighting/settings.h"

#include <concepts>
#include <span>
#include <variant>

/// What every strategy can do once it is built for a set of luminaires. Deterministic for a given
/// key.
template <class T>
concept LightStrategy = requires(const T& built, const ShadingPoint& point, const Key& key,
                                 LightPicks& picks) {
    built.choose(point, key, picks);  // appends the picks
    {
        built.expected(point, key, LightIndex{})
        } -> std::convertible_to<double>;  // given what the key has drawn before the choice
    { built.memory_bytes() } -> std::convertible_to<std::size_t>;
};

namespace sampler_detail {
template <class>
struct BuiltOf;
template <class... Settings>
struct BuiltOf<std::variant<Settings...>> {
    using type = std::variant<decltype(build(std::declval<const Settings&>(),
                                             std::declval<const LightScene&>(), 0))...>;
};
template <class>
constexpr bool all_strategies = false;
template <class... Built>
constexpr bool all_strategies<std::variant<Built...>> = (LightStrategy<Built> && ...);
}  // namespace sampler_detail

/// A strategy that is ready to be asked, for each alternative of LightSampler in the same order.
/// Refers to the luminaires it was built for. The default one knows of none.
using BuiltLightSampler = sampler_detail::BuiltOf<LightSampler>::type;
static_assert(sampler_detail::all_strategies<BuiltLightSampler>);

/// Builds what the settings ask for. The answer does not depend on the number of threads (0: one
/// per core).
inline BuiltLightSampler build(const LightSampler& settings, const LightScene& scene, int threads) {
    return std::visit([&](const auto& s) { return BuiltLightSampler(build(s, scene, threads)); },
                      settings);
}
