// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Targa files (Truevision TGA File Format Specification, version 2.0).
#pragma once

#include "oiio/formats.h"

#include <string>

namespace candelabra {

/// Encodes a picture of bytes with one to four channels, in runs if its compression is "rle".
/// The comment of the file has as much of the description as it can hold. Returns an error message,
/// or an empty string.
std::string write_tga(const RawPicture&, std::string& bytes);

}  // namespace candelabra
