// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture file says of itself before a reader is trusted with it: its format, by its first
// bytes and among those that the language names only, and whether it has bytes enough for the size
// that it says. Called before OpenImageIO opens a file, as its readers reserve memory by then.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace candelabra {

struct Claim {
    std::string_view format;  ///< in OpenImageIO's words; empty: none that the language names
    std::string problem;      ///< why it cannot be what it says; empty when it can
};

/// Of the bytes of a whole file. Formats whose readers reserve nothing early are not looked into.
Claim claim_of(std::string_view bytes);

/// How many bytes of pixels one byte of a file can hold at most, by the rules of the format and its
/// compression (in OpenImageIO's words).
double max_growth(std::string_view format, std::string_view compression);

/// Pixels that a reader has room for at least. Tiles that are not large do not count: some formats
/// cut them at the edge.
double covered(double width, double height, double tile_width, double tile_height);

/// Why so many bytes of pixels cannot be in a file of so many bytes; empty when they can.
std::string too_large(double pixel_bytes, double growth, std::size_t file_bytes);

}  // namespace candelabra
