// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/tga_writer.h"

#include "raster/bytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace candelabra {

namespace {

using namespace std::literals;

/// A pixel as the file has it: blue, green, red, alpha, or grey, alpha.
std::string stored_pixel(const std::uint8_t* channels, int count) {
    std::string pixel(channels, channels + count);
    if (count >= 3) std::swap(pixel[0], pixel[2]);
    return pixel;
}

/// Appends the pixels of a row in packets. A packet is a byte and a pixel that is repeated, or a
/// byte and pixels that follow each other.
void append_packets(std::string_view row, std::size_t pixel, std::string& bytes) {
    constexpr std::size_t longest = 128;
    constexpr std::size_t repeats = 0x80;
    const auto same = [&](std::size_t i) {
        return (i + 2) * pixel <= row.size() &&
               row.substr(i * pixel, pixel) == row.substr((i + 1) * pixel, pixel);
    };
    for (std::size_t i = 0; i * pixel < row.size();) {
        const bool run = same(i);
        std::size_t end = i + 1;
        while (end * pixel < row.size() && end - i < longest && (run ? same(end - 1) : !same(end)))
            ++end;
        bytes += static_cast<char>((run ? repeats : 0) + end - i - 1);
        bytes += row.substr(i * pixel, (run ? 1 : end - i) * pixel);
        i = end;
    }
}

/// The extension area: the description in four lines, the program, and what alpha is.
std::string extension_area(std::string_view description, bool alpha) {
    constexpr std::uint32_t size = 495;
    constexpr std::size_t comment_at = 43, lines = 4, line = 80, program_at = 426, version_at = 467;
    std::string area;
    append_low_first(area, size, 2);
    area.resize(size);
    for (std::size_t i = 0; i < lines && !description.empty(); ++i) {
        const std::string_view part = description.substr(0, line);
        std::ranges::copy(part, area.begin() + static_cast<std::ptrdiff_t>(comment_at) +
                                    static_cast<std::ptrdiff_t>(i * (line + 1)));
        description.remove_prefix(part.size());
    }
    std::ranges::copy("Candelabra"sv, area.begin() + static_cast<std::ptrdiff_t>(program_at));
    area[version_at + 2] = ' ';         // no version
    area.back() = alpha ? '\3' : '\0';  // colours are not multiplied by it
    return area;
}

}  // namespace

std::string write_tga(const RawPicture& picture, std::string& bytes) {
    constexpr int largest = 0xffff;
    const auto* values = std::get_if<std::vector<std::uint8_t>>(&picture.values);
    if (!values) return "it has bytes only";
    if (picture.width < 1 || picture.height < 1) return "it has no pixels";
    if (picture.width > largest || picture.height > largest)
        return "a Targa file has at most 65535 pixels along each side";
    const bool packed = picture.compression == "rle", grey = picture.channels < 3,
               alpha = picture.channels % 2 == 0;
    const auto pixel = static_cast<std::size_t>(picture.channels);

    bytes = "\0\0"s;
    bytes += static_cast<char>((grey ? 3 : 2) + (packed ? 8 : 0));
    bytes.resize(12);
    append_low_first(bytes, static_cast<std::uint32_t>(picture.width), 2);
    append_low_first(bytes, static_cast<std::uint32_t>(picture.height), 2);
    bytes += static_cast<char>(8 * pixel);
    bytes += alpha ? '\10' : '\0';  // bits of alpha; the lowest row comes first
    const std::size_t width = static_cast<std::size_t>(picture.width) * pixel;
    for (auto y = static_cast<std::size_t>(picture.height); y-- > 0;) {
        std::string row;
        for (std::size_t at = 0; at < width; at += pixel)
            row += stored_pixel(values->data() + y * width + at, picture.channels);
        if (packed)
            append_packets(row, pixel, bytes);
        else
            bytes += row;
    }
    if (bytes.size() > 0xffffffff) return "a Targa file has at most 4 GiB";
    const auto extension = static_cast<std::uint32_t>(bytes.size());
    bytes += extension_area(picture.description, alpha);
    append_low_first(bytes, extension, 4);
    append_low_first(bytes, 0, 4);  // no area of developers
    bytes += "TRUEVISION-XFILE.\0"sv;
    return {};
}

}  // namespace candelabra
