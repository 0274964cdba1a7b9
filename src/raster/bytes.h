// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers for raster files: bytes of a file that may end early, pixel values, and numbers to write.
#pragma once

#include "oiio/formats.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns a byte, or 0 beyond the end.
inline std::uint32_t byte_in(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

/// Returns a little-endian 16-bit number.
inline std::uint32_t low_word(std::string_view bytes, std::size_t at) {
    return byte_in(bytes, at) | byte_in(bytes, at + 1) << 8;
}

/// Appends a number of so many bytes, the lowest first.
inline void append_low_first(std::string& bytes, std::uint32_t number, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

/// Returns a value from 0 to 1, rounded as OpenImageIO does.
inline float unit_value(std::uint8_t byte) { return static_cast<float>(byte) * (1.0F / 255); }
inline float unit_value(std::uint16_t word) { return static_cast<float>(word) * (1.0F / 65535); }

/// Whether a picture has pixels, but not more than max_pixels.
inline bool has_size(std::int64_t width, std::int64_t height, std::int64_t max_pixels) {
    return width > 0 && height > 0 && width <= max_pixels && height <= max_pixels / width;
}

}  // namespace candelabra
