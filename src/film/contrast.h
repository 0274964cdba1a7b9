// SPDX-License-Identifier: GPL-3.0-or-later
// Antialiasing where nothing is left to chance, as POV-Ray's first method has it: one ray through
// the middle of each pixel, and a square of others where it differs from a pixel beside it.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/vector.h"
#include "film/picture_shard.h"
#include "scene/settings.h"

#include <optional>

namespace candelabra {

/// A place of a picture as it is compared with others.
struct DisplayValue {
    Vec3 colour = Vec3(0);
    double clear = 0;  ///< where a picture has an alpha channel
};

/// When two places of a picture differ.
struct Contrast {
    double threshold;      ///< of the difference, summed over the channels
    double assumed_gamma;  ///< of the colours in the film
    double gamma;          ///< of those that are compared
    double exposure = 1;   ///< the light's factor as it is shown

    DisplayValue shown(const Vec3& colour, double clear) const;
    bool between(const DisplayValue&, const DisplayValue&) const;
};

/// `exposure`: the light's factor as it is shown.
Contrast contrast_of(const RenderSettings&, double assumed_gamma, double exposure = 1);

struct ContrastRule {
    Contrast contrast;
    int across;     ///< rays in a row of the square, and rows
    double jitter;  ///< how far rays are moved at random, in parts of the distance between two
};

ContrastRule contrast_rule(const RenderSettings&, double assumed_gamma, double exposure = 1);

/// Of a pixel that differs from one beside it.
std::uint32_t all_samples(const ContrastRule&);

/// What the pixels of a block are asked for, one at a time.
struct ContrastPixels {
    /// What its first ray shows; also of the pixels above the block and to its left.
    FunctionRef<DisplayValue(int x, int y)> first;
    /// What all of its rays show; nothing to stop.
    FunctionRef<std::optional<DisplayValue>(int x, int y)> all;
};

/// Goes through a block row by row, and asks for all rays of pixels that differ from the one to
/// their left or above, as these are by then; and for those of the other, if it is in the block.
/// False when it was stopped. Blocks know nothing of each other, so the picture may be made in any
/// order.
bool refine_block(const Contrast&, const Region& block, const ContrastPixels&);

/// Where the ray of a sample passes its pixel, from the left and upper edge, in pixels.
Vec2 place_in_pixel(const ContrastRule&, const Key&);

}  // namespace candelabra
