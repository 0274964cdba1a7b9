// SPDX-License-Identifier: GPL-3.0-or-later
// Reads OpenEXR files of the usual kind: one part of scan lines, uncompressed or compressed with
// zlib. The library of all formats reads the others.
#pragma once

#include "oiio/formats.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace candelabra {

/// Whether the bytes are a file of this kind. No other reader is needed for one, even if damaged.
bool reads_exr(std::string_view bytes);

/// Reads the text attributes that the picture already names, and all planes. Floats of 16 bits
/// become 32. Returns an error message, or an empty string. A picture of more than `max_pixels` is
/// rejected, and one for which the file has too few bytes, before memory is reserved for it.
std::string read_exr(std::string_view bytes, std::int64_t max_pixels, LayeredPicture&);

/// Reads the colours: red, green and blue, or brightness, with alpha if there is one.
std::string read_exr(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

}  // namespace candelabra
