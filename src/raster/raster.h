// SPDX-License-Identifier: GPL-3.0-or-later
// GIF, JPEG, PNM and TIFF files as most programs write them, read without the library of all
// formats, which takes longer to open than most scenes take. Called by picture/ before that
// library, with the same results. A file of a rarer kind, and one that seems damaged, is left to
// the library, which knows more kinds and says what is wrong.
#pragma once

#include "oiio/formats.h"

namespace candelabra {

/// Reads the bytes of a file. False: it is to be left to others, and the picture is as it was.
bool read_raster(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

}  // namespace candelabra
