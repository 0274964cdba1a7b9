// SPDX-License-Identifier: GPL-3.0-or-later
// How many samples each pixel gets, round by round. A round is planned from the samples of the
// rounds before and nothing else, so that a picture can be stopped at any moment and continued
// without a trace.
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

/// A picture on its way.
struct RenderState {
    Film film;
    PictureShard shard;
    std::uint32_t rounds = 0;  ///< that have been planned

    friend bool operator==(const RenderState&, const RenderState&) = default;
};

/// Before the first sample. `aovs`: sums for each pixel besides the picture's.
RenderState begin_picture(const RenderSettings&, std::size_t aovs = 0);

/// Pixels get more samples by the noise of those around them.
struct NoiseRule {
    std::uint32_t at_most = 0;  ///< altogether; 0: as many as the settings allow
};

/// What decides how many samples follow those of the first round. BlurRule: the camera's own;
/// ContrastRule and CornerRule: none do.
using SampleRule = std::variant<NoiseRule, BlurRule, ContrastRule, CornerRule>;

/// Whether the first round is the last one, in which tiles find out what their pixels need.
bool is_settled_by_tiles(const SampleRule&);

/// Whether the settings, and the rule for what follows, give all pixels the number of samples that
/// is asked for. Neither an adaptive scheme nor a lens does so.
bool is_even(const RenderSettings&, const SampleRule& = {});

/// Sets the pixels' targets for the next round. `samples` is what each pixel gets in the first
/// round, or altogether when that number is even. False when no pixel needs more.
bool plan_round(RenderState&, const RenderSettings&, std::uint32_t samples, const SampleRule& = {});

/// The greatest target that the rounds can set, whatever the samples say.
std::uint32_t max_wanted(const RenderSettings&, std::uint32_t samples, const SampleRule& = {});

/// What pixels are wanted to have up to now.
struct Wanted {
    std::uint64_t samples = 0;
    std::uint64_t missing = 0;  ///< of these
    std::uint32_t most = 0;     ///< in one pixel

    void add(const PixelSum& pixel) {
        samples += pixel.target;
        if (pixel.target > pixel.samples) missing += pixel.target - pixel.samples;
        most = std::max(most, pixel.target);
    }
};
Wanted wanted_samples(const Film&);

}  // namespace candelabra
