// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic antialiasing, as in POV-Ray's first method: one ray through the centre of each
// pixel, and a square of further rays where it differs from an adjacent pixel.
#pragma once

#include "base/function_ref.h"
#include "film/contrast.h"
#include "film/rule_kind.h"

#include <optional>

namespace candelabra {

struct ContrastRule {
    Contrast contrast;
    int across;     ///< number of rays in each row and column of the square
    double jitter;  ///< maximum random offset of rays, as a fraction of their distance

    static std::optional<ContrastRule> chosen(const RuleChoice&);
    static DecidedBy decided_by(const RenderSettings&) { return DecidedBy::tile; }
    /// More than one planned sample requests the comparison, whatever its result.
    static int first(const FirstSamples&) { return 2; }
    static std::uint32_t most(const RenderSettings&, std::uint32_t first) { return first; }
    static void refine(RenderState&, const RenderSettings&) {}
    std::optional<Vec2> place(const Key&) const;
    std::uint64_t make(TileSamples&, std::uint32_t level) const;

    /// Number of samples of a pixel that differs from an adjacent one.
    std::uint32_t all_samples() const { return static_cast<std::uint32_t>(1 + across * across); }
};

ContrastRule contrast_rule(const RenderSettings&, double assumed_gamma, double exposure = 1);

/// Callbacks for the pixels of a block.
struct ContrastPixels {
    /// Returns the value of the first ray; also called for the pixels above the block and to its
    /// left.
    FunctionRef<DisplayValue(int x, int y)> first;
    /// Returns the value of all rays, or nothing to stop.
    FunctionRef<std::optional<DisplayValue>(int x, int y)> all;
};

/// Visits a block row by row and refines each pixel that differs from its current left or upper
/// neighbour, as well as that neighbour if it is in the block. Returns false if it was stopped.
/// Blocks are independent, so the picture may be made in any order.
bool refine_block(const Contrast&, const Region& block, const ContrastPixels&);

}  // namespace candelabra
