// SPDX-License-Identifier: GPL-3.0-or-later
// JPEG files of one or three components, by libjpeg; none where the program is built without it.
// Called by read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Nothing where the file is of another kind, has too many pixels or seems damaged.
std::optional<StoredPicture> read_jpeg(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
