// SPDX-License-Identifier: GPL-3.0-or-later
// Writes OpenEXR files (openexr.com, "OpenEXR File Layout"): one part of scan lines of 32 bits,
// compressed with zlib. The bytes are those that OpenImageIO and OpenEXR would write.
#pragma once

#include "oiio/formats.h"

#include <string>

namespace candelabra {

/// Encodes a picture of floats. Returns an error message, or an empty string.
std::string write_exr(const RawPicture&, std::string& bytes);
/// Encodes all planes and texts. Two planes, or two texts, must not have the same name.
std::string write_exr(const LayeredPicture&, std::string& bytes);

}  // namespace candelabra
