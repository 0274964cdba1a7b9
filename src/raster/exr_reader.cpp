// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/exr_reader.h"

#include "base/size_product.h"
#include "raster/bytes.h"
#include "raster/exr_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <zlib.h>

namespace candelabra {

namespace {

constexpr auto ends_early = "it is damaged or ends too early";

std::uint32_t exr_number(std::string_view bytes, std::size_t at) {
    return low_word(bytes, at) | low_word(bytes, at + 2) << 16;
}

/// Removes a zero-terminated text from the front and returns it; nothing if it has no end.
std::optional<std::string> take_exr_text(std::string_view& rest) {
    const std::size_t end = rest.find('\0');
    if (end == rest.npos) return std::nullopt;
    std::string text(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    return text;
}

struct ExrPlane {
    std::string name;
    std::uint32_t type = 0;
    bool everywhere = true;  ///< it has a value at each pixel

    std::size_t bytes() const { return type == exr_half ? 2 : 4; }
};

/// The list of channels; nothing if it is damaged.
std::optional<std::vector<ExrPlane>> planes_of(std::string_view list) {
    constexpr std::size_t entry = 16;
    std::vector<ExrPlane> planes;
    for (;;) {
        auto name = take_exr_text(list);
        if (!name) return std::nullopt;
        if (name->empty()) return planes;
        if (list.size() < entry) return std::nullopt;
        const bool everywhere = exr_number(list, 8) == 1 && exr_number(list, 12) == 1;
        planes.push_back({std::move(*name), exr_number(list, 0), everywhere});
        list.remove_prefix(entry);
    }
}

struct ExrFile {
    std::map<std::string, std::string_view> attributes;
    std::vector<ExrPlane> planes;
    std::int64_t left = 0, top = 0, width = 0, height = 0;
    unsigned char compression = 0;
    std::string_view table;  ///< the chunks' places, and all behind them

    std::size_t rows_of_chunk() const { return compression == exr_zip ? exr_zip_rows : 1; }
    std::size_t row_bytes() const {
        std::size_t bytes = 0;
        for (const ExrPlane& plane : planes) bytes += plane.bytes();
        return size_product(bytes, static_cast<std::size_t>(width));
    }
};

/// Reads the head of a file; nothing if it is damaged or of another kind.
std::optional<ExrFile> exr_head(std::string_view bytes) {
    constexpr std::size_t first = 8;
    constexpr std::uint32_t version = 2, version_mask = 0xff, long_names = 0x400;
    if (!bytes.starts_with(exr_magic) || bytes.size() < first) return std::nullopt;
    const std::uint32_t kind = exr_number(bytes, 4);
    if ((kind & version_mask) != version || (kind & ~(version_mask | long_names)) != 0)
        return std::nullopt;
    ExrFile file;
    std::string_view rest = bytes.substr(first);
    for (;;) {
        const auto name = take_exr_text(rest);
        if (!name) return std::nullopt;
        if (name->empty()) break;
        const auto type = take_exr_text(rest);
        constexpr std::size_t length_bytes = 4;
        if (!type || rest.size() < length_bytes) return std::nullopt;
        const std::size_t length = exr_number(rest, 0);
        rest.remove_prefix(length_bytes);
        if (length > rest.size()) return std::nullopt;
        file.attributes.emplace(*name, rest.substr(0, length));
        rest.remove_prefix(length);
    }
    file.table = rest;
    const std::string_view window = file.attributes["dataWindow"];
    const std::string_view compression = file.attributes["compression"];
    auto planes = planes_of(file.attributes["channels"]);
    if (!planes || planes->empty() || window.size() != 16 || compression.size() != 1)
        return std::nullopt;
    file.planes = std::move(*planes);
    file.compression = static_cast<unsigned char>(compression[0]);
    const auto corner = [&](std::size_t at) {
        return std::int64_t{static_cast<std::int32_t>(exr_number(window, at))};
    };
    file.left = corner(0);
    file.top = corner(4);
    file.width = corner(8) - file.left + 1;
    file.height = corner(12) - file.top + 1;
    return file;
}

bool is_usual(const ExrFile& file) {
    constexpr std::array known = {exr_none, exr_zips, exr_zip};
    return std::ranges::find(known, file.compression) != known.end() &&
           std::ranges::all_of(file.planes, [](const ExrPlane& plane) {
               return plane.everywhere && plane.type <= exr_float;
           });
}

/// Returns a half as the bits of a float.
std::uint32_t widened(std::uint32_t half) {
    const std::uint32_t sign = (half & 0x8000) << 16, exponent = half >> 10 & 31,
                        fraction = half & 0x3ff;
    constexpr std::uint32_t bias = 127 - 15, all = 255;
    if (exponent == 31) return sign | all << 23 | fraction << 13;
    if (exponent != 0) return sign | (exponent + bias) << 23 | fraction << 13;
    // Small numbers are a multiple of 2^-24.
    return sign | std::bit_cast<std::uint32_t>(static_cast<float>(fraction) * 0x1p-24F);
}

/// Returns the values of a chunk, or nothing if it is damaged.
std::optional<std::string> unpacked(std::string_view chunk, std::size_t raw_bytes,
                                    unsigned char compression) {
    if (chunk.size() == raw_bytes) return std::string(chunk);
    if (compression == exr_none || chunk.size() > raw_bytes) return std::nullopt;
    std::string split(raw_bytes, '\0');
    auto size = static_cast<uLongf>(raw_bytes);
    if (uncompress(reinterpret_cast<Bytef*>(split.data()), &size,
                   reinterpret_cast<const Bytef*>(chunk.data()),
                   static_cast<uLong>(chunk.size())) != Z_OK ||
        size != raw_bytes)
        return std::nullopt;
    return exr_joined(std::move(split));
}

/// Puts the values of a chunk into the planes, from row `first` on.
void spread(const std::string& raw, const ExrFile& file, std::size_t first, std::size_t rows,
            std::vector<ChannelPlane>& planes) {
    const auto width = static_cast<std::size_t>(file.width);
    std::size_t at = 0;
    for (std::size_t y = first; y < first + rows; ++y)
        for (std::size_t p = 0; p < planes.size(); ++p) {
            const std::size_t bytes = file.planes[p].bytes();
            for (std::size_t x = 0; x < width; ++x, at += bytes)
                planes[p].bits[y * width + x] =
                    bytes == 2 ? widened(low_word(raw, at)) : exr_number(raw, at);
        }
}

/// Describes why the file cannot have the pixels that its head states; empty if it can.
std::string size_problem(const ExrFile& file, std::int64_t max_pixels, std::size_t file_bytes) {
    if (!has_size(file.width, file.height, max_pixels))
        return "its header has " + std::to_string(file.width) + " by " +
               std::to_string(file.height) + " pixels";
    constexpr std::size_t most_planes = 1024;
    if (file.planes.size() > most_planes)
        return "its header has " + std::to_string(file.planes.size()) + " channels";
    constexpr double most_growth = 1032;  // of zlib
    const double raw = static_cast<double>(file.row_bytes()) * static_cast<double>(file.height);
    if (raw > most_growth * static_cast<double>(file_bytes))
        return "its header has more pixels than the file has room for";
    return {};
}

}  // namespace

bool reads_exr(std::string_view bytes) {
    const auto file = exr_head(bytes);
    return file && is_usual(*file);
}

std::string read_exr(std::string_view bytes, std::int64_t max_pixels, LayeredPicture& picture) {
    const auto file = exr_head(bytes);
    if (!file || !is_usual(*file)) return ends_early;
    if (std::string problem = size_problem(*file, max_pixels, bytes.size()); !problem.empty())
        return problem;
    LayeredPicture made{static_cast<int>(file->width), static_cast<int>(file->height), {}, {}};
    bool whole = false, halves = false;
    for (const ExrPlane& plane : file->planes) {
        whole |= plane.type == exr_uint;
        halves |= plane.type == exr_half;
        made.planes.push_back({plane.name, plane.type == exr_uint, {}});
        made.planes.back().bits.resize(static_cast<std::size_t>(file->width * file->height));
    }
    if (whole && halves) return "its channels do not have 32 bits each";
    const auto height = static_cast<std::size_t>(file->height);
    const std::size_t rows = file->rows_of_chunk(), chunks = (height + rows - 1) / rows;
    constexpr std::size_t place_bytes = 8, chunk_head = 8;
    if (file->table.size() < place_bytes * chunks) return ends_early;
    std::vector<bool> filled(chunks);
    for (std::size_t i = 0; i < chunks; ++i) {
        const std::uint64_t place = exr_number(file->table, place_bytes * i) |
                                    std::uint64_t{exr_number(file->table, place_bytes * i + 4)}
                                        << 32;
        if (place > bytes.size() || bytes.size() - place < chunk_head) return ends_early;
        const auto at = static_cast<std::size_t>(place);
        const std::int64_t first = static_cast<std::int32_t>(exr_number(bytes, at)) - file->top;
        const std::size_t size = exr_number(bytes, at + 4);
        if (first < 0 || first >= file->height || first % static_cast<std::int64_t>(rows) != 0 ||
            size > bytes.size() - at - chunk_head)
            return ends_early;
        const auto y = static_cast<std::size_t>(first);
        const std::size_t count = std::min(rows, height - y);
        const auto raw = unpacked(bytes.substr(at + chunk_head, size),
                                  size_product(count, file->row_bytes()), file->compression);
        if (!raw || filled[y / rows]) return ends_early;
        filled[y / rows] = true;
        spread(*raw, *file, y, count, made.planes);
    }
    made.texts = std::move(picture.texts);
    for (auto& [name, text] : made.texts) {
        const auto found = file->attributes.find(name);
        text = found == file->attributes.end() ? std::string() : std::string(found->second);
    }
    picture = std::move(made);
    return {};
}

std::string read_exr(std::string_view bytes, std::int64_t max_pixels, StoredPicture& picture) {
    LayeredPicture layers;
    if (std::string problem = read_exr(bytes, max_pixels, layers); !problem.empty()) return problem;
    const auto plane = [&](std::string_view name) -> const ChannelPlane* {
        const auto found = std::ranges::find(layers.planes, name, &ChannelPlane::name);
        return found == layers.planes.end() || found->whole ? nullptr : &*found;
    };
    std::vector<const ChannelPlane*> colours = {plane("R"), plane("G"), plane("B")};
    if (std::ranges::count(colours, nullptr) != 0) colours = {plane("Y")};
    if (!colours[0]) return "it has neither the channels R, G and B nor Y";
    StoredPicture made;
    made.width = layers.width;
    made.height = layers.height;
    made.channels = static_cast<int>(colours.size());
    made.bits = 32;
    made.linear = true;
    made.format = "openexr";
    const std::size_t pixels = colours[0]->bits.size();
    made.values.reserve(pixels * colours.size());
    for (std::size_t i = 0; i < pixels; ++i)
        for (const ChannelPlane* each : colours)
            made.values.push_back(std::bit_cast<float>(each->bits[i]));
    if (const ChannelPlane* const alpha = plane("A"))
        for (const std::uint32_t bits : alpha->bits)
            made.alpha.push_back(std::bit_cast<float>(bits));
    picture = std::move(made);
    return {};
}

}  // namespace candelabra
