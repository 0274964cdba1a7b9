// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/page_frames.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candelabra {

std::optional<PageFrames> page_frames(const LightShow& show, std::size_t most_bytes) {
    PageFrames made;
    made.count = std::max<std::size_t>(show.frames(), 1);
    const std::size_t lamps = show.names().lamps().size();
    if (lamps > 0 && made.count > most_bytes / lamps) return std::nullopt;
    double most = 0;
    for (std::size_t frame = 0; frame < made.count; ++frame)
        for (const Rgb& factor : show.factors(frame)) {
            made.grey &= factor.r == factor.g && factor.g == factor.b;
            most = std::max(most, max_abs_component(factor));
        }
    if (most > 0) made.scale = most;
    const std::size_t channels = made.grey ? 1 : 3;
    if (lamps > 0 && made.count > most_bytes / (lamps * channels)) return std::nullopt;
    std::vector<unsigned> before(lamps * channels);
    made.bytes.reserve(before.size() * made.count);
    for (std::size_t frame = 0; frame < made.count; ++frame) {
        const std::vector<Rgb> factors = show.factors(frame);
        for (std::size_t i = 0; i < before.size(); ++i) {
            constexpr double greatest = 255;
            const double factor = factors[i / channels][static_cast<int>(i % channels)];
            const auto code =
                static_cast<unsigned>(std::lround(greatest * std::sqrt(factor / made.scale)));
            made.bytes += static_cast<char>(code - before[i]);
            before[i] = code;
        }
    }
    return made;
}

}  // namespace candelabra
