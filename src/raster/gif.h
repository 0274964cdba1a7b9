// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the first picture of a GIF file ("GRAPHICS INTERCHANGE FORMAT Version 89a", CompuServe
// 1990). As in POV-Ray, it has its own size, whatever the file says of a screen that it lies on.
// Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Returns nothing if the file is of another kind, has too many pixels or appears damaged.
std::optional<StoredPicture> read_gif(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
