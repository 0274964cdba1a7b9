// SPDX-License-Identifier: GPL-3.0-or-later
// The number of samples of each pixel, round by round. A round is planned only from the samples of
// previous rounds, so that a picture can be stopped and continued at any moment with the same
// result.
#pragma once

#include "film/render_state.h"
#include "film/sample_rule.h"

namespace candelabra {

/// Returns the state before the first sample. `aovs`: number of further sums per pixel. `pages`:
/// for the film, if it is not to lie in memory of its own.
RenderState begin_picture(const RenderSettings&, std::size_t aovs = 0,
                          std::optional<ZeroedPages> pages = {});

/// Plans the samples of the pixels for the next round. `samples`: number per pixel in the first
/// round, or in total if it is uniform. Returns false if no pixel needs more.
bool plan_round(RenderState&, const RenderSettings&, std::uint32_t samples,
                const SampleRule& = NoiseRule());

/// Returns the greatest number of samples that the rounds can plan, regardless of the samples.
std::uint32_t max_wanted(const RenderSettings&, std::uint32_t samples,
                         const SampleRule& = NoiseRule());

}  // namespace candelabra
