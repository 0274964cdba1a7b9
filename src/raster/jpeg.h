// SPDX-License-Identifier: GPL-3.0-or-later
// Reads JPEG files of one or three components with libjpeg; reads none if the program is built
// without it. Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Returns nothing if the file is of another kind, has too many pixels or appears damaged.
std::optional<StoredPicture> read_jpeg(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
