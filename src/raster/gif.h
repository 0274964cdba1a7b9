// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the first picture of a GIF file on the file's canvas (W3C, "GRAPHICS INTERCHANGE FORMAT
// Version 89a"). Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Returns nothing if the file is of another kind, has too many pixels or appears damaged.
std::optional<StoredPicture> read_gif(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
