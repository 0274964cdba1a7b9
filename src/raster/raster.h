// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the common variants of GIF, JPEG, PNM and TIFF files without OpenImageIO, which takes
// longer to load than most scenes take to read. Called by picture/ before OpenImageIO, with the
// same results. Rarer variants and files that appear damaged are left to OpenImageIO, which
// supports more variants and reports errors.
//
// JPEG files are read by libjpeg. GIF and TIFF files have readers here. giflib and libtiff would
// save some 200 lines of them. But libtiff depends on six more libraries (WebP, Zstandard, LZMA,
// LERC, JBIG, Deflate): they would add 2 ms to each start of the program, and hostile files could
// choose among their formats. These readers check the size of a picture before they allocate it,
// and are fuzzed (tests/fuzz/picture_fuzz.cpp).
#pragma once

#include "oiio/formats.h"

namespace candelabra {

/// Decodes the bytes of a file. Returns false if other readers should try; the picture is then
/// unchanged.
bool read_raster(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

}  // namespace candelabra
