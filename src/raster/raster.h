// SPDX-License-Identifier: GPL-3.0-or-later
// GIF, JPEG, PNM and TIFF files as most programs write them, read without the library of all
// formats, which takes longer to open than most scenes take. Called by picture/ before that
// library, with the same results. A file of a rarer kind, and one that seems damaged, is left to
// the library, which knows more kinds and says what is wrong.
//
// JPEG files are read by libjpeg. GIF and TIFF files have readers of their own here. giflib and
// libtiff would save some 200 lines of them. But libtiff brings six more libraries (WebP,
// Zstandard, LZMA, LERC, JBIG, Deflate): they would add 2 ms to each start of the program, and
// hostile files could choose among their formats. These readers know the size of a picture before
// they allocate it, and are fuzzed (tests/fuzz/picture_fuzz.cpp).
#pragma once

#include "oiio/formats.h"

namespace candelabra {

/// Reads the bytes of a file. False: it is to be left to others, and the picture is as it was.
bool read_raster(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

}  // namespace candelabra
