// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tile.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Number of samples between questions whether to stop.
constexpr std::uint64_t samples_between_questions = 16;

}  // namespace

bool TileMaker::stopped() {
    return made_ % samples_between_questions == 0 ? interruption_.ask() : interruption_.stopped();
}

std::uint64_t TileMaker::bring(int x, int y, std::uint32_t samples) {
    const std::uint64_t before = made_;
    PixelSum& pixel = film().at(x, y);
    const std::span<ExactSum> extra = aovs_of(x, y);
    for (; pixel.samples < samples && !stopped(); ++made_) {
        const std::uint32_t sample = first_sample_ + pixel.samples;
        const bool first = sample == 0;
        // All rays come before the first sum: work that ends meanwhile leaves the pixel as it was.
        const PrimaryHit middle = first ? tracer_.seen_at_middle(x, y) : PrimaryHit();
        const SeenSample seen = tracer_.look(x, y, sample, extra);
        pixel.add(seen.colour, seen.negative, tracer_.exposure());
        pixel.shadow_rays += seen.shadow_rays;
        if (first) gather_middle(aovs_, middle, extra);
    }
    return made_ - before;
}

PixelSample TileMaker::look(int x, int y, std::uint32_t sample) {
    extra_.assign(film().aovs(), ExactSum());
    const SeenSample seen = tracer_.look(x, y, sample, extra_);
    PixelSample values{seen.colour, 0, {}, seen.shadow_rays};
    for (const ExactSum& each : extra_) values.extra.push_back(each.value());
    if (aovs_.alpha) values.clear = values.extra.front();
    return values;
}

void TileMaker::add(int x, int y, const PixelSample& seen) {
    const PrimaryHit middle = tracer_.seen_at_middle(x, y);
    PixelSum& pixel = film().at(x, y);
    const std::span<ExactSum> extra = aovs_of(x, y);
    pixel.add(seen.colour, false, tracer_.exposure());
    pixel.shadow_rays += seen.shadow_rays;
    for (std::size_t i = 0; i < extra.size(); ++i) extra[i].add(seen.extra[i]);
    gather_middle(aovs_, middle, extra);
    ++made_;
}

double TileMaker::clear(int x, int y) const {
    return aovs_.alpha ? film().at(x, y).mean_of(aovs_of(x, y).front().value()) : 0;
}

}  // namespace candelabra
