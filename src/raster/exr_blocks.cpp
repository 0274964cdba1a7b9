// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/exr_blocks.h"

namespace candelabra {

namespace {

constexpr unsigned middle = 128;

unsigned byte_at(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

}  // namespace

std::string exr_split(std::string_view raw) {
    std::string result;
    result.reserve(raw.size());
    for (const std::size_t start : {std::size_t{0}, std::size_t{1}})
        for (std::size_t i = start; i < raw.size(); i += 2) result += raw[i];
    for (std::size_t i = result.size(); i-- > 1;)
        result[i] = static_cast<char>(byte_at(result, i) - byte_at(result, i - 1) + middle);
    return result;
}

std::string exr_joined(std::string split) {
    for (std::size_t i = 1; i < split.size(); ++i)
        split[i] = static_cast<char>(byte_at(split, i) + byte_at(split, i - 1) - middle);
    std::string result(split.size(), '\0');
    const std::size_t half = (split.size() + 1) / 2;
    for (std::size_t i = 0; i < split.size(); ++i) {
        const std::size_t from = i % 2 == 0 ? i / 2 : half + i / 2;
        result[i] = split[from];
    }
    return result;
}

}  // namespace candelabra
