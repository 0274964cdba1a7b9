// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/heights.h"

#include "picture/formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

namespace {

constexpr double most = 65535;

unsigned byte_at(const std::string& bytes, std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
}

using Palette = std::vector<std::array<unsigned, 3>>;

Palette colours(const std::string& bytes, std::size_t first, std::size_t count) {
    Palette result;
    for (std::size_t i = first; i < first + 3 * count && i + 2 < bytes.size(); i += 3)
        result.push_back({byte_at(bytes, i), byte_at(bytes, i + 1), byte_at(bytes, i + 2)});
    return result;
}

/// The colours that a PNG or GIF file numbers; none for other files, and for those without.
Palette palette(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    if (bytes.starts_with("GIF8") && (byte_at(bytes, 10) & 0x80) != 0)
        return colours(bytes, 13, std::size_t{2} << (byte_at(bytes, 10) & 7));
    constexpr std::size_t colour_type = 25;
    if (!bytes.starts_with("\x89PNG") || byte_at(bytes, colour_type) != 3) return {};
    for (std::size_t at = 8; at + 8 < bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | byte_at(bytes, at + i);
        if (bytes.compare(at + 4, 4, "PLTE") == 0) return colours(bytes, at + 8, length / 3);
        at += length + 12;
    }
    return {};
}

/// The number of a pixel's colour.
double number_of(const Palette& palette, const StoredPicture& picture, const float* value) {
    std::array<unsigned, 3> colour;
    for (std::size_t i = 0; i < 3; ++i)
        colour[i] = static_cast<unsigned>(std::lround(255 * value[picture.channels < 3 ? 0 : i]));
    const auto found = std::ranges::find(palette, colour);
    return static_cast<double>(found - palette.begin());
}

/// A pixel's height; `value` are its channels from 0 to 1.
double height_of(const StoredPicture& picture, const Palette& palette, const float* value) {
    if (!palette.empty()) return 256 * number_of(palette, picture, value);
    if (picture.channels < 3) return most * value[0];
    if (picture.bits == 8) return (256.0 * value[0] + value[1]) * 255;
    return most * (0.297 * value[0] + 0.589 * value[1] + 0.114 * value[2]);
}

}  // namespace

std::optional<Heights> read_heights(const std::string& path, double gamma, Diagnostics& diagnostics,
                                    Span asked_at) {
    std::optional<StoredPicture> read = read_stored(path, diagnostics, asked_at);
    if (!read) return std::nullopt;
    StoredPicture& stored = *read;
    if (gamma > 0)
        for (float& value : stored.values)
            value = std::pow(std::max(0.0F, value), static_cast<float>(gamma));
    const Palette numbered = palette(path);
    Heights result{stored.width, stored.height, {}};
    const auto width = static_cast<std::size_t>(stored.width);
    const auto channels = static_cast<std::size_t>(stored.channels);
    for (auto row = static_cast<std::size_t>(stored.height); row-- > 0;)
        for (std::size_t x = 0; x < width; ++x) {
            const double height =
                height_of(stored, numbered, &stored.values[(row * width + x) * channels]);
            // 1/255 has no exact float.
            result.values.push_back(
                static_cast<std::uint16_t>(std::clamp(std::floor(height + 1e-2), 0.0, most)));
        }
    return result;
}
