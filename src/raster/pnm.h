// SPDX-License-Identifier: GPL-3.0-or-later
// PGM and PPM files, of text or of bytes, whose greatest value is 255. Called by
// read_raster().
#pragma once

#include "oiio/formats.h"

#include <optional>

namespace candelabra {

/// Nothing where the file is of another kind, has too many pixels or seems damaged.
std::optional<StoredPicture> read_pnm(std::string_view bytes, std::int64_t max_pixels);

}  // namespace candelabra
