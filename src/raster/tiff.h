// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TIFF files of integers in strips: grey, RGB or palette, uncompressed or compressed by LZW,
// Deflate or PackBits (Adobe, "TIFF Revision 6.0"). Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Returns nothing if the file is of another kind, has too many pixels or appears damaged.
std::optional<StoredPicture> read_tiff(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
