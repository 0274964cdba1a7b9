// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/file_facts.h"

#include "picture/tga.h"
#include "png/png.h"
#include "raster/gif.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace candelabra {

namespace {

unsigned byte_at(const std::string& bytes, std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
}

void add_colours(FileFacts& facts, const std::string& bytes, std::size_t first, std::size_t count) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(byte_at(bytes, i)); };
    for (std::size_t i = first; i < first + 3 * count && i + 2 < bytes.size(); i += 3)
        facts.table.push_back({byte(i), byte(i + 1), byte(i + 2), 255});
}

/// Reads the chunks of a PNG file that precede its pixels.
void read_png(const std::string& bytes, FileFacts& facts) {
    constexpr std::size_t colour_type = 25, first_chunk = 8, most = 1 << 16;
    constexpr unsigned numbered = 3;
    facts.says_coding = false;
    for (std::size_t at = first_chunk; at + 8 < bytes.size() && facts.table.size() < most;) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | byte_at(bytes, at + i);
        const std::string name = bytes.substr(at + 4, 4);
        if (name == "IDAT") return;
        if (name == "gAMA" || name == "sRGB") facts.says_coding = true;
        if (byte_at(bytes, colour_type) == numbered && name == "PLTE")
            add_colours(facts, bytes, at + 8, length / 3);
        if (name == "tRNS")
            for (std::size_t i = 0; i < std::min(length, facts.table.size()); ++i)
                facts.table[i][3] = static_cast<std::uint8_t>(byte_at(bytes, at + 8 + i));
        at += length + 12;
    }
}

}  // namespace

FileFacts file_facts(const Found& file) {
    FileFacts facts;
    const std::string& bytes = file.text;
    const bool gif = bytes.starts_with("GIF8"), png = is_png(bytes);
    const bool tga = is_tga(file.path);
    if (!gif && !png && !tga) return facts;
    if (png)
        read_png(bytes, facts);
    else if (tga)
        facts.table = tga_table(bytes);
    else
        facts.table = gif_table(bytes);
    return facts;
}

ColourNumbers::ColourNumbers(const FileFacts& facts) : none_(facts.table.size()) {
    for (std::size_t i = 0; i < facts.table.size(); ++i)
        numbers_.emplace(std::bit_cast<std::uint32_t>(facts.table[i]), i);
}

std::size_t ColourNumbers::operator()(std::span<const float> pixel, float alpha) const {
    const auto byte = [](float value) {
        // Not-a-number becomes 0.
        return static_cast<std::uint8_t>(255 * std::fmin(1.0F, std::fmax(0.0F, value)) + 0.5F);
    };
    const std::array<std::uint8_t, 4> colour = {byte(pixel[0]), byte(pixel[pixel.size() / 2]),
                                                byte(pixel.back()), byte(alpha)};
    const auto found = numbers_.find(std::bit_cast<std::uint32_t>(colour));
    return found == numbers_.end() ? none_ : found->second;
}

}  // namespace candelabra
