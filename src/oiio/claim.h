// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the claims of a picture file before a reader is trusted with it: its format, by its first
// bytes and only among those that the language names and WebP, and whether the file has enough
// bytes for its stated size. Called before OpenImageIO opens a file, since its readers reserve
// memory then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace candelabra {

struct Claim {
    std::string_view format;  ///< in OpenImageIO's terms; empty: none that the language names
    std::string problem;      ///< why the claims cannot be true; empty if they can
};

/// Returns the claim of a whole file. Formats whose readers reserve no memory early are not checked
/// further.
Claim claim_of(std::string_view bytes);

/// Returns the maximum number of pixel bytes per byte of a file, for a format and its compression
/// (in OpenImageIO's terms).
double max_growth(std::string_view format, std::string_view compression);

/// Returns the minimum number of pixels that a reader reserves memory for. Only large tiles count,
/// since some formats crop small ones at the edge.
double covered(double width, double height, double tile_width, double tile_height);

/// Describes why a file of this size cannot hold so many bytes of pixels; empty if it can.
std::string too_large(double pixel_bytes, double growth, std::size_t file_bytes);

}  // namespace candelabra
