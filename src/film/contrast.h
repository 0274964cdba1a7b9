// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic antialiasing, as in POV-Ray's first method: one ray through the centre of each
// pixel, and a square of further rays where it differs from an adjacent pixel.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/vector.h"
#include "film/picture_shard.h"
#include "scene/settings.h"

#include <optional>

namespace candelabra {

/// The value of a pixel for comparisons with others.
struct DisplayValue {
    Vec3 colour = Vec3(0);
    double clear = 0;  ///< transparency, if the picture has an alpha channel
};

/// Decides whether two values differ.
struct Contrast {
    double threshold;      ///< maximum difference, summed over the channels
    double assumed_gamma;  ///< of the colours in the film
    double gamma;          ///< of the compared colours
    double exposure = 1;   ///< factor on the radiance for display

    DisplayValue shown(const Vec3& colour, double clear) const;
    bool between(const DisplayValue&, const DisplayValue&) const;
};

/// `exposure`: the factor on the radiance for display.
Contrast contrast_of(const RenderSettings&, double assumed_gamma, double exposure = 1);

struct ContrastRule {
    Contrast contrast;
    int across;     ///< number of rays in each row and column of the square
    double jitter;  ///< maximum random offset of rays, as a fraction of their distance
};

ContrastRule contrast_rule(const RenderSettings&, double assumed_gamma, double exposure = 1);

/// Returns the number of samples of a pixel that differs from an adjacent one.
std::uint32_t all_samples(const ContrastRule&);

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

/// Returns the position of a sample's ray from the left and upper edge of its pixel, in pixels.
Vec2 place_in_pixel(const ContrastRule&, const Key&);

}  // namespace candelabra
