// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader and the writer of OpenEXR files share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace candelabra {

inline constexpr std::string_view exr_magic = "\x76\x2f\x31\x01";

/// Types of channels.
inline constexpr std::uint32_t exr_uint = 0, exr_half = 1, exr_float = 2;
/// Compressions by zlib, of single rows and of several, and none.
inline constexpr unsigned char exr_none = 0, exr_zips = 2, exr_zip = 3;
inline constexpr std::size_t exr_zip_rows = 16;

/// Puts the bytes at even places before those at odd ones, and replaces each byte by its difference
/// to the one before, which zlib compresses better.
std::string exr_split(std::string_view raw);
/// The reverse.
std::string exr_joined(std::string split);

}  // namespace candelabra
