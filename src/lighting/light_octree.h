// SPDX-License-Identifier: GPL-3.0-or-later
// The light octree: cells with cuts, or, when the settings say so, the paper's lists of bright
// luminaires. Built and asked like any other strategy.
#pragma once

#include "lighting/cut_octree.h"
#include "lighting/paper_octree.h"

#include <variant>

class BuiltLightOctree {
public:
    explicit BuiltLightOctree(BuiltCutOctree&& built) : built_(std::move(built)) {}
    explicit BuiltLightOctree(BuiltPaperOctree&& built) : built_(std::move(built)) {}

    void choose(const ShadingPoint& point, const Key& key, LightPicks& picks) const {
        std::visit([&](const auto& b) { b.choose(point, key, picks); }, built_);
    }
    double expected(const ShadingPoint& point, const Key& key, LightIndex light) const {
        return std::visit([&](const auto& b) { return b.expected(point, key, light); }, built_);
    }
    std::size_t memory_bytes() const {
        return std::visit([](const auto& b) { return b.memory_bytes(); }, built_);
    }
    /// Null when it is the paper's.
    const BuiltCutOctree* cuts() const { return std::get_if<BuiltCutOctree>(&built_); }

private:
    std::variant<BuiltCutOctree, BuiltPaperOctree> built_;
};

inline BuiltLightOctree build(const LightOctree& settings, const LightScene& scene, int threads) {
    if (settings.paper) return BuiltLightOctree(BuiltPaperOctree(settings, scene, threads));
    return BuiltLightOctree(BuiltCutOctree(settings, scene));
}
