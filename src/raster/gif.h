// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the first picture of a GIF file ("GRAPHICS INTERCHANGE FORMAT Version 89a", CompuServe
// 1990). As in POV-Ray, it has its own size, whatever the file says of a screen that it lies on.
// Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace candelabra {

/// Colours with alpha.
using GifTable = std::vector<std::array<std::uint8_t, 4>>;

/// The colours to which the numbers of read_gif() refer: those of the first picture's own table or
/// of the file's, and black ones up to 256. The clear one has alpha 0. Empty if the file appears
/// damaged.
GifTable gif_table(std::string_view bytes);

/// Returns nothing if the file is of another kind, has too many pixels or appears damaged.
std::optional<StoredPicture> read_gif(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
