// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/read.h"

#include "base/colour.h"
#include "picture/formats.h"

#include <algorithm>
#include <cmath>

namespace {

/// From a stored value to a linear one, by what the file says about itself.
double decoded(float stored, const StoredPicture& picture) {
    if (picture.linear) return stored;
    return picture.gamma > 0 ? std::pow(static_cast<double>(stored), picture.gamma)
                             : srgb_decode(stored);
}

}  // namespace

std::optional<Image> read_picture(const std::string& path, Diagnostics& diagnostics,
                                  Span asked_at) {
    const std::optional<StoredPicture> read = read_stored(path, diagnostics, asked_at);
    if (!read) return std::nullopt;
    const StoredPicture& stored = *read;
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
