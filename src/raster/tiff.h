// SPDX-License-Identifier: GPL-3.0-or-later
// TIFF files of whole numbers in strips: grey, colours or a table of colours, bare or packed by
// LZW, Deflate or PackBits (Adobe, "TIFF Revision 6.0"). Called by
// read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Nothing where the file is of another kind, has too many pixels or seems damaged.
std::optional<StoredPicture> read_tiff(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
