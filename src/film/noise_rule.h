// SPDX-License-Identifier: GPL-3.0-or-later
// The requested number of samples for all pixels, or the adaptive scheme of Shirley and Wang
// (Figure 5): a few rays everywhere, more where the variance is high. It is unbiased, since the
// number of further rays of a pixel depends on its neighbours' samples, which are independent of
// its own.
#pragma once

#include "film/rule_kind.h"

#include <optional>

namespace candelabra {

/// When a pixel has enough samples.
struct NoiseBound {
    double error;           ///< sufficient standard error: display values, summed over the channels
    std::uint32_t at_most;  ///< maximum samples of a pixel, including those it has
};

/// Returns the number of samples that the pixel needs besides those it has; 0 where its
/// neighbourhood is smooth.
std::uint32_t samples_to_add(const Film&, int x, int y, const NoiseBound&);

struct NoiseRule {
    std::uint32_t at_most = 0;  ///< in total, for light without noise; 0: as the settings say

    /// Suits every picture.
    static std::optional<NoiseRule> chosen(const RuleChoice&);
    static DecidedBy decided_by(const RenderSettings&);
    int first(const FirstSamples&) const;
    std::uint32_t most(const RenderSettings&, std::uint32_t first) const;
    void refine(RenderState&, const RenderSettings&) const;
    static std::optional<Vec2> place(const Key&) { return {}; }
    static std::uint64_t make(TileSamples& tile, std::uint32_t level) {
        return tile.bring_all(level);
    }

private:
    NoiseBound bound(const RenderSettings&) const;
};

}  // namespace candelabra
