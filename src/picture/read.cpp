// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/read.h"

#include "base/colour.h"
#include "picture/formats.h"
#include "text/harmless.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

/// Larger pictures are taken for damaged files rather than read.
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// From a stored value to a linear one, by what the file says about itself.
double decoded(float stored, const StoredPicture& picture) {
    if (picture.linear) return stored;
    return picture.gamma > 0 ? std::pow(static_cast<double>(stored), picture.gamma)
                             : srgb_decode(stored);
}

}  // namespace

std::optional<Image> read_picture(const std::string& path, Diagnostics& diagnostics,
                                  Span asked_at) {
    const Formats* formats = picture_formats(diagnostics, asked_at);
    if (!formats) return std::nullopt;
    StoredPicture stored;
    const std::string problem = formats->read(path, most_pixels, stored);
    if (!problem.empty()) {
        diagnostics.add(
            error(Fault::io, asked_at,
                  message("cannot read the picture `", harmless(path), "`: ", harmless(problem))));
        return std::nullopt;
    }
    Image image(stored.width, stored.height);
    const auto channels = static_cast<std::size_t>(stored.channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto value = [&](std::size_t channel) {
            return decoded(stored.values[channels * i + std::min(channel, channels - 1)], stored);
        };
        image.pixels[i] = Vec3(value(0), value(1), value(2));
    }
    return image;
}
