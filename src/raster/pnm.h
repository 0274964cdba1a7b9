// SPDX-License-Identifier: GPL-3.0-or-later
// Reads PGM and PPM files, text or binary, with a maximum value of 255. Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Returns nothing if the file is of another kind, has too many pixels or appears damaged.
std::optional<StoredPicture> read_pnm(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
