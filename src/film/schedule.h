// SPDX-License-Identifier: GPL-3.0-or-later
// The number of samples of each pixel, round by round. A round is planned only from the samples of
// previous rounds, so that a picture can be stopped and continued at any moment with the same
// result.
#pragma once

#include "camera/camera.h"
#include "film/contrast.h"
#include "film/corners.h"
#include "film/film.h"
#include "film/picture_shard.h"
#include "scene/settings.h"

#include <algorithm>
#include <variant>

namespace candelabra {

/// An unfinished picture.
struct RenderState {
    Film film;
    PictureShard shard;
    std::uint32_t rounds = 0;  ///< planned so far

    friend bool operator==(const RenderState&, const RenderState&) = default;
};

/// Returns the state before the first sample. `aovs`: number of further sums per pixel.
RenderState begin_picture(const RenderSettings&, std::size_t aovs = 0);

/// Pixels get more samples according to the noise of their neighbourhood.
struct NoiseRule {
    std::uint32_t at_most = 0;  ///< in total; 0: as many as the settings allow
};

/// The rule for further samples after the first round. BlurRule is the camera's own; ContrastRule
/// and CornerRule add none.
using SampleRule = std::variant<NoiseRule, BlurRule, ContrastRule, CornerRule>;

/// Whether the first round is the last, because tiles determine the samples of their pixels
/// themselves.
bool is_settled_by_tiles(const SampleRule&);

/// Whether the settings and the rule give all pixels exactly the requested number of samples.
/// Adaptive schemes and lenses do not.
bool is_even(const RenderSettings&, const SampleRule& = {});

/// Sets the targets of the pixels for the next round. `samples`: number per pixel in the first
/// round, or in total if it is uniform. Returns false if no pixel needs more.
bool plan_round(RenderState&, const RenderSettings&, std::uint32_t samples, const SampleRule& = {});

/// Returns the greatest target that the rounds can set, regardless of the samples.
std::uint32_t max_wanted(const RenderSettings&, std::uint32_t samples, const SampleRule& = {});

/// Totals of the pixels' targets so far.
struct Wanted {
    std::uint64_t samples = 0;
    std::uint64_t missing = 0;  ///< those not yet taken
    std::uint32_t most = 0;     ///< in one pixel

    void add(const PixelSum& pixel) {
        samples += pixel.target;
        if (pixel.target > pixel.samples) missing += pixel.target - pixel.samples;
        most = std::max(most, pixel.target);
    }
};
Wanted wanted_samples(const Film&);

}  // namespace candelabra
