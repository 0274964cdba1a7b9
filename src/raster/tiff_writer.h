// SPDX-License-Identifier: GPL-3.0-or-later
// Writes TIFF files of 8 or 16 bits in each channel, compressed by Deflate (Adobe, "TIFF Revision
// 6.0"). OpenImageIO's writer makes no valid file in memory, and the library would not be needed
// otherwise. Called by picture/.
#pragma once

#include "oiio/formats.h"

#include <string>

namespace candelabra {

/// Encodes 1 or 3 channels, and perhaps one more for alpha, by which colours are not multiplied.
/// Precondition: the values are integers. Returns an error message, or an empty string.
std::string write_tiff(const RawPicture&, std::string& bytes);

}  // namespace candelabra
