// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes PNG files by libpng, which is linked directly: most pictures are PNG files, and
// loading OpenImageIO takes longer than rendering many pictures. Called by picture/ instead of
// OpenImageIO; results are the same.
#pragma once

#include "oiio/formats.h"

namespace candelabra {

/// Whether the bytes begin with the PNG signature.
bool is_png(std::string_view bytes);

/// Decodes the bytes of a file. Rejects pictures of more than `max_pixels`. Returns an error
/// message, or an empty string.
std::string read_png(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

/// Encodes a file of 8 or 16 bits per channel, marked as sRGB. Returns an error message, or an
/// empty string.
std::string write_png(const RawPicture&, std::string& bytes);

}  // namespace candelabra
