// SPDX-License-Identifier: GPL-3.0-or-later
// All light strategies: the interface of each once it is built, and a variant of them. Estimators
// of light query them by light_query.h, and know no strategy by name.
#pragma once

#include "base/random.h"
#include "lighting/constant_alpha.h"
#include "lighting/cut_octree.h"
#include "lighting/every_light.h"
#include "lighting/light_bvh.h"
#include "lighting/linear_alpha.h"
#include "lighting/paper_octree.h"
#include "lighting/settings.h"

#include <concepts>
#include <span>
#include <variant>

namespace candelabra {

/// The interface of every strategy once it is built for a set of luminaires. Deterministic for a
/// given key.
template <class T>
concept LightStrategy = requires(const T& built, const LightQuery& query) {
    { built.at(query) } -> LightAnswer;
    { built.memory_bytes() } -> std::convertible_to<std::size_t>;
};

/// A strategy that is ready for queries. Refers to the luminaires for which it was built. The
/// default one has none.
using BuiltLightSampler = std::variant<BuiltEveryLight, BuiltConstantAlpha, BuiltLinearAlpha,
                                       BuiltLightBvh, BuiltCutOctree, BuiltPaperOctree>;

template <class>
inline constexpr bool are_strategies = false;
template <class... Built>
inline constexpr bool are_strategies<std::variant<Built...>> = (LightStrategy<Built> && ...);
static_assert(are_strategies<BuiltLightSampler>);

/// The light octree's cells have cuts or, if the settings say so, the paper's lists.
inline BuiltLightSampler build(const LightOctree& settings, const LightScene& scene, int threads) {
    if (settings.paper) return BuiltPaperOctree(settings.as_in_paper(), scene, threads);
    return BuiltCutOctree(settings, scene, threads);
}

/// Builds the strategy of the settings. The result does not depend on the number of threads (0: one
/// per core).
inline BuiltLightSampler build(const LightSampler& settings, const LightScene& scene, int threads) {
    return std::visit([&](const auto& s) { return BuiltLightSampler(build(s, scene, threads)); },
                      settings);
}

}  // namespace candelabra
