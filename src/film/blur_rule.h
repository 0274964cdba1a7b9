// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of a picture behind a lens: each pixel gets as many as its own mean needs, as in POV-Ray.
#pragma once

#include "film/rule_kind.h"

#include <optional>

namespace candelabra {

struct BlurRule {
    BlurRays rays;  ///< of the camera

    static std::optional<BlurRule> chosen(const RuleChoice&);
    static DecidedBy decided_by(const RenderSettings&) { return DecidedBy::pixel; }
    int first(const FirstSamples&) const;
    std::uint32_t most(const RenderSettings&, std::uint32_t first) const;
    /// As POV-Ray does, but not after each sample.
    void refine(RenderState&, const RenderSettings&) const;
    static std::optional<Vec2> place(const Key&) { return {}; }
    static std::uint64_t make(TileSamples& tile, std::uint32_t level) {
        return tile.bring_all(level);
    }
};

}  // namespace candelabra
