// SPDX-License-Identifier: GPL-3.0-or-later
// Writes PPM and PGM files (netpbm.sourceforge.net/doc/ppm.html).
#pragma once

#include "oiio/formats.h"

#include <string>

namespace candelabra {

/// Encodes a picture of bytes without alpha. Returns an error message, or an empty string.
std::string write_pnm(const RawPicture&, std::string& bytes);

}  // namespace candelabra
