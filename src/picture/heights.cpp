// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/heights.h"

#include "base/elementary.h"
#include "picture/file_facts.h"
#include "picture/formats.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace candelabra {

namespace {

constexpr double most = 65535;

/// The colour table with alpha ignored: heights do not depend on it.
FileFacts facts_without_alpha(const Found& file) {
    FileFacts facts = file_facts(file);
    for (auto& colour : facts.table) colour[3] = 255;
    return facts;
}

/// Height of the pixel with this index.
double height_of(const StoredPicture& picture, const ColourNumbers* number_of, std::size_t pixel) {
    if (!picture.numbers.empty()) return 256.0 * picture.numbers[pixel];
    const auto channels = static_cast<std::size_t>(picture.channels);
    const float* const value = &picture.values[pixel * channels];
    if (number_of) return 256 * static_cast<double>((*number_of)({value, channels}, 1));
    if (keeps_whole_brightness(picture)) return most * whole_brightness(value[0]);
    if (picture.channels < 3) return most * value[0];
    if (picture.bits == 8) return (256.0 * value[0] + value[1]) * 255;
    return most * (0.297 * value[0] + 0.589 * value[1] + 0.114 * value[2]);
}

}  // namespace

std::optional<Heights> read_heights(const Found& file, double gamma, Diagnostics& diagnostics,
                                    Span asked_at) {
    std::optional<StoredPicture> read = read_stored(file, diagnostics, asked_at);
    if (!read) return std::nullopt;
    StoredPicture& stored = *read;
    const FileFacts facts = facts_without_alpha(file);
    // Heights by colour numbers have no gamma.
    if (gamma > 0 && facts.table.empty())
        for (float& value : stored.values)
            value = math::pow(std::max(0.0F, value), static_cast<float>(gamma));
    const ColourNumbers number_of(facts);
    Heights result{stored.width, stored.height, {}};
    const auto width = static_cast<std::size_t>(stored.width);
    for (auto row = static_cast<std::size_t>(stored.height); row-- > 0;)
        for (std::size_t x = 0; x < width; ++x) {
            const double height =
                height_of(stored, facts.table.empty() ? nullptr : &number_of, row * width + x);
            // 1/255 has no exact float, hence the 1e-2. Not-a-number becomes 0.
            result.values.push_back(static_cast<std::uint16_t>(
                std::fmin(most, std::fmax(0, std::floor(height + 1e-2)))));
        }
    return result;
}

Heights of_two_halves(const Heights& whole) {
    constexpr unsigned step = 256;
    Heights result{whole.width / 2, whole.height, {}};
    const auto width = static_cast<std::size_t>(whole.width), half = width / 2;
    for (std::size_t row = 0; row < whole.values.size(); row += width)
        for (std::size_t x = 0; x < half; ++x) {
            const unsigned high = whole.values[row + x] / step;
            const unsigned low = whole.values[row + half + x] / step;
            result.values.push_back(static_cast<std::uint16_t>(step * high + low));
        }
    return result;
}

}  // namespace candelabra
