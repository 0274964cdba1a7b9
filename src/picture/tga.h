// SPDX-License-Identifier: GPL-3.0-or-later
// Targa files as POV-Ray reads them where other programs differ: those whose pixels are numbers of
// colours in a table, and those of 15 or 16 bits a pixel. The library of all formats reads the
// others.
#pragma once

#include "oiio/formats.h"

#include <array>

namespace candelabra {

/// Whether a file is one by the end of its name: Targa files have no other mark.
bool is_tga(std::string_view path);

/// The colours that a file of numbers has: red, green, blue, alpha. Empty for others.
std::vector<std::array<std::uint8_t, 4>> tga_table(std::string_view bytes);

/// Whether the bytes are a file of these kinds: damaged or not, nobody else reads it.
bool reads_tga(std::string_view bytes);

/// Reads the bytes of a file. False, and the picture as it was, when the file is none of these, is
/// damaged, or has more than `max_pixels`.
bool read_tga(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

}  // namespace candelabra
