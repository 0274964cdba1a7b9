// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/hdr_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

namespace {

/// The mantissas of the channels, and the exponent that they share.
std::array<std::uint8_t, 4> with_exponent(std::span<const float, 3> colour) {
    constexpr float least = 1e-32F;  // below, a pixel is black
    constexpr int bias = 128;
    const float most = std::ranges::max(colour);
    if (!(most >= least)) return {};
    int exponent = 0;
    const float scale = std::frexp(most, &exponent) * 256.0F / most;
    const auto mantissa = [&](float value) { return static_cast<std::uint8_t>(value * scale); };
    return {mantissa(colour[0]), mantissa(colour[1]), mantissa(colour[2]),
            static_cast<std::uint8_t>(exponent + bias)};
}

/// The length of the run of equal bytes at the front.
std::size_t run_at(std::string_view bytes) {
    constexpr std::size_t longest = 127;
    std::size_t length = 0;
    while (length < std::min(bytes.size(), longest) && bytes[length] == bytes[0]) ++length;
    return length;
}

/// Appends the bytes of one channel of a row. Runs are a length above 128 and a byte; other bytes
/// have their number before them.
void append_runs(std::string_view bytes, std::string& result) {
    constexpr std::size_t worth = 4;  // a shorter run between others saves nothing
    constexpr std::size_t most_others = 128;
    const auto append_run = [&](std::size_t length, char byte) {
        result += static_cast<char>(128 + length);
        result += byte;
    };
    while (!bytes.empty()) {
        std::size_t others = 0, run = 0, last = 0;
        while (others < bytes.size() && (run = run_at(bytes.substr(others))) < worth) {
            last = run;
            others += run;
        }
        if (others == bytes.size()) run = 0;
        if (last > 1 && last == others) {  // all before the long run is one short run
            append_run(others, bytes[0]);
            bytes.remove_prefix(others);
            others = 0;
        }
        while (others > 0) {
            const std::size_t part = std::min(others, most_others);
            result += static_cast<char>(part);
            result += bytes.substr(0, part);
            bytes.remove_prefix(part);
            others -= part;
        }
        if (run == 0) continue;
        append_run(run, bytes[0]);
        bytes.remove_prefix(run);
    }
}

}  // namespace

std::string write_hdr(const RawPicture& picture, std::string& bytes) {
    const auto* values = std::get_if<std::vector<float>>(&picture.values);
    if (!values || picture.channels != 3) return "it has three floats for each pixel only";
    bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(picture.height) + " +X " +
            std::to_string(picture.width) + "\n";
    const auto width = static_cast<std::size_t>(picture.width);
    constexpr std::size_t least = 8, most = 0x7fff;  // widths of rows with runs
    const bool runs = width >= least && width <= most;
    for (std::size_t first = 0; first < values->size(); first += 3 * width) {
        std::array<std::string, 4> channels;
        for (std::size_t x = 0; x < width; ++x) {
            const auto pixel =
                with_exponent(std::span<const float, 3>(values->data() + first + 3 * x, 3));
            for (std::size_t c = 0; c < pixel.size(); ++c) {
                if (!runs) bytes += static_cast<char>(pixel[c]);
                channels[c] += static_cast<char>(pixel[c]);
            }
        }
        if (!runs) continue;
        for (const std::size_t byte : {std::size_t{2}, std::size_t{2}, width >> 8, width & 0xff})
            bytes += static_cast<char>(byte);
        for (const std::string& channel : channels) append_runs(channel, bytes);
    }
    return {};
}

}  // namespace candelabra
