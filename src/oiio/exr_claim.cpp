// SPDX-License-Identifier: GPL-3.0-or-later
#include "oiio/exr_claim.h"

#include "oiio/claim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace candelabra {

namespace {

double number(std::string_view bytes, std::size_t at, bool below_zero) {
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i-- > 0;)
        bits = bits << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0);
    return below_zero ? static_cast<double>(static_cast<std::int32_t>(bits)) : bits;
}

/// Removes a zero-terminated text from the front and returns it.
std::string_view take_text(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    const std::string_view text = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return text;
}

/// The compression of chunks, and the number of rows in each.
struct Compression {
    std::string_view name;
    int lines;
};
constexpr auto compressions = std::to_array<Compression>({{"none", 1},
                                                          {"rle", 1},
                                                          {"zips", 1},
                                                          {"zip", 16},
                                                          {"piz", 32},
                                                          {"pxr24", 16},
                                                          {"b44", 32},
                                                          {"b44a", 32},
                                                          {"dwaa", 32},
                                                          {"dwab", 256}});

struct Part {
    double width = 0, height = 0, tile_width = 0, tile_height = 0;
    std::size_t compression = 0;

    void take(std::string_view name, std::string_view value) {
        if (name == "dataWindow") {
            width = number(value, 8, true) - number(value, 0, true) + 1;
            height = number(value, 12, true) - number(value, 4, true) + 1;
        } else if (name == "tiles") {
            tile_width = number(value, 0, false);
            tile_height = number(value, 4, false);
        } else if (name == "compression") {
            compression = value.empty() ? 0 : static_cast<unsigned char>(value[0]);
        }
    }
    /// Returns the number of chunks, which have an entry of eight bytes each in the file.
    double chunks() const {
        if (tile_width > 0 && tile_height > 0)
            return std::ceil(width / tile_width) * std::ceil(height / tile_height);
        return std::ceil(height / compressions[compression].lines);
    }
    std::string problem(std::size_t file_bytes) const {
        if (!(width >= 1 && height >= 1)) return "it has no pixels";
        if (compression >= compressions.size()) return "its compression is not known";
        constexpr double entry = 8;
        const std::string wrong = too_large(entry * chunks(), 1, file_bytes);
        if (!wrong.empty()) return wrong;
        // A value has at least two bytes.
        return too_large(2 * covered(width, height, tile_width, tile_height),
                         max_growth("openexr", compressions[compression].name), file_bytes);
    }
};

}  // namespace

std::string exr_problem(std::string_view bytes) {
    constexpr auto early = "it ends in its head";
    constexpr std::size_t first = 8, flags = 5;
    constexpr unsigned char many_parts = 0x10;
    if (bytes.size() < first) return early;
    const bool several = (static_cast<unsigned char>(bytes[flags]) & many_parts) != 0;
    std::string_view rest = bytes.substr(first);
    for (bool begun = false;; begun = true) {
        Part part;
        std::string_view name = take_text(rest);
        if (name.empty()) return begun ? "" : "it has no head";
        for (; !name.empty(); name = take_text(rest)) {
            if (rest.empty()) return early;
            take_text(rest);  // its type
            const double length = number(rest, 0, false);
            rest.remove_prefix(std::min<std::size_t>(4, rest.size()));
            if (length > static_cast<double>(rest.size())) return early;
            part.take(name, rest.substr(0, static_cast<std::size_t>(length)));
            rest.remove_prefix(static_cast<std::size_t>(length));
            if (rest.empty()) return early;
        }
        const std::string wrong = part.problem(bytes.size());
        if (!wrong.empty() || !several) return wrong;
    }
}

}  // namespace candelabra
