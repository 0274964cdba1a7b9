// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Targa files where POV-Ray's interpretation differs from other programs': files of indexed
// colours, and files of 15 or 16 bits per pixel. The library of all formats reads the others.
#pragma once

#include "oiio/formats.h"

#include <array>

namespace candelabra {

/// Whether the name ends as a Targa file's; the content has no reliable signature.
bool is_tga(std::string_view path);

/// Returns the colour table of an indexed file: red, green, blue, alpha. Empty for other files.
std::vector<std::array<std::uint8_t, 4>> tga_table(std::string_view bytes);

/// Whether the bytes are a file of these kinds. No other reader is tried for one, even if damaged.
bool reads_tga(std::string_view bytes);

/// Decodes the file into the picture. Returns false and leaves the picture unchanged if the file is
/// of another kind, is damaged, or has more than `max_pixels`.
bool read_tga(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

}  // namespace candelabra
