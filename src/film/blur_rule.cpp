// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/blur_rule.h"

#include <algorithm>

namespace candelabra {

std::optional<BlurRule> BlurRule::chosen(const RuleChoice& choice) {
    if (choice.is_requested() || !choice.camera.blurs()) return {};
    return BlurRule{choice.camera.blur};
}

int BlurRule::first(const FirstSamples& wanted) const {
    return std::max({2, rays.least, wanted.least});
}

std::uint32_t BlurRule::most(const RenderSettings&, std::uint32_t first) const {
    return std::max(first, static_cast<std::uint32_t>(rays.most));
}

void BlurRule::refine(RenderState& state, const RenderSettings&) const {
    const auto most = static_cast<std::uint32_t>(rays.most);
    for_pixels(state.film, [&](int x, int y, PixelSum& pixel) {
        const std::uint32_t n = pixel.samples;
        if (state.shard.owns(x, y) && pixel.variance_of_mean() > rays.allowed(static_cast<int>(n)))
            pixel.planned = std::min(most, n + n / 4 + 1);
    });
}

}  // namespace candelabra
